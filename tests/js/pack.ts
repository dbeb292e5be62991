import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Obstacle } from "parkade";

const here = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

export const PACKAGE = here("pkg/");

export function npm(args: string[], cwd: string): string {
  const quiet = ["--offline", "--no-audit", "--no-fund", "--loglevel=error"];
  const [program, first] = process.platform === "win32" ? ["cmd", ["/C", "npm"]] : (["npm", []] as const);
  return execFileSync(program, [...first, ...args, ...quiet], { cwd, encoding: "utf8" });
}

/** A new folder with nothing but the packed package and what it depends on. */
export function installed(): string {
  const folder = mkdtempSync(join(tmpdir(), "parkade-"));
  const packed = [
    PACKAGE,
    ...["tinypool", "hyparquet", "hyparquet-writer"].map((name) => here(`node_modules/${name}`)),
  ].map(
    (from) => JSON.parse(npm(["pack", "--json", "--ignore-scripts", "--pack-destination", folder], from))[0].filename,
  );
  writeFileSync(join(folder, "package.json"), JSON.stringify({ private: true, type: "module" }));
  npm(["install", ...packed.map((file) => `./${file}`)], folder);
  return folder;
}

/** So many blocks a hair apart in the middle of the built-in scene `perpendicular`, for which hybrid A* takes long. */
export const slowly = (count: number): Obstacle[] =>
  Array.from({ length: count }, (_, i) => ({ type: "rectangle", center: [i * 1e-9, 7.5], size: [1, 1] }));

export interface Ran {
  status: number | null;
  out: string;
  err: string;
}

/** Runs the package's command, the one built or the one installed in a folder. */
export function parkade(args: string[], cwd: string, input = "", script = join(PACKAGE, "cli/main.js")): Ran {
  const { status, stdout, stderr } = spawnSync(process.execPath, [script, ...args], {
    cwd,
    input,
    encoding: "utf8",
    maxBuffer: 1e8,
  });
  return { status, out: stdout, err: stderr };
}
