/** The JavaScript reference: TypeDoc writes a page for each exported name, from the package's types. */
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const FOLDER = here("typedoc/");
/** Written anew by every build. */
export const PAGES = here("../api/js/");

interface Item {
  text: string;
  link?: string;
  items?: Item[];
}

/** Writes the pages; returns their entries of the sidebar. */
export function reference(): Item[] {
  execFileSync(process.execPath, [here("typedoc/node_modules/typedoc/bin/typedoc"), "--options", "typedoc.json"], {
    cwd: FOLDER,
    stdio: ["ignore", "ignore", "inherit"],
  });
  const entries = `${PAGES}typedoc-sidebar.json`;
  return existsSync(entries) ? (JSON.parse(readFileSync(entries, "utf8")) as Item[]) : [];
}
