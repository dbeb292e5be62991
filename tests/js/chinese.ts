import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { vi } from "vitest";
import { loadLang } from "../../www/src/i18n/index";

/** Fetches the page's Chinese from the sources, as a browser does from the site. */
export async function loadChinese(): Promise<void> {
  vi.stubGlobal("fetch", (url: URL) =>
    Promise.resolve(
      new Response(readFileSync(join(import.meta.dirname, "../../www/src/i18n", basename(url.pathname)))),
    ),
  );
  const lang = await loadLang("zh");
  vi.unstubAllGlobals();
  if (lang !== "zh") throw new Error("the Chinese words did not come");
}
