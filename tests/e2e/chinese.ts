/** Finds English on the Chinese page. */
import { expect, type Page } from "@playwright/test";
import type { PlaygroundElement } from "./playground";

/**
 * What Chinese engineers write in Latin letters: names, formats, units, fields of the scene and of files, values of
 * settings, keys, and the names of this test's files.
 */
export const NAMES = new RegExp(
  [
    "Parkade",
    "English",
    "EN",
    "[0-9a-f]{16}",
    "[0-9a-f]{8}",
    "Markdown",
    "Node",
    "PNG",
    "SVG",
    "CSV",
    "DXF",
    "TEXT",
    "GIF",
    "WebM",
    "MP4",
    "px",
    "AASHTO",
    "Pkw",
    "Design Bulletin",
    "SUV",
    "JSON",
    "MovingAI",
    "ROS",
    "TPCAP",
    "Theta",
    "theta",
    "phi",
    "omega",
    "gear",
    "NBA",
    "Reeds",
    "Shepp",
    "Posthoc",
    "Dubins",
    "Dijkstra",
    "RRT",
    "Voronoi",
    "RMS",
    "Ctrl",
    "Shift",
    "Alt",
    "Cmd",
    "Enter",
    "Esc(ape)?",
    "Del(ete)?",
    "Backspace",
    "Tab",
    "kB",
    "MB",
    "mm",
    "ms",
    "rad",
    "exp",
    "Bd",
    "id",
    "los",
    "auto",
    "comfort",
    "classic",
    "vehicle\\.\\w+",
    "vehicle",
    "max",
    "none",
    "first",
    "best",
    "nba",
    "naive",
    "spline",
    "paper",
    "octile",
    "L_aa",
    "steps",
    "cargo xtask paper \\w+",
    "slot-\\d+",
    "obstacle-\\d+",
    "practical",
    "metre",
    "\\.GS@OTW",
    "free_thresh",
    "occupied_thresh",
    "\\.(map|scen|yaml|pgm|csv|json)",
    "(room|floor|case|note|lot)(\\.\\w+)*",
    "start\\.\\w+",
    "broken\\.[\\w.]+",
  ]
    .map((name) => `(?<![A-Za-z])${name}(?![A-Za-z])`)
    .join("|"),
  "g",
);

/** Papers as they are cited: their authors and the year. */
const CITED = /(?:[A-Z][A-Za-z]+, )*[A-Z][A-Za-z]+(?: 等)? \d{4}/g;

/** Keeps what is drawn into maps and charts of pages opened from now on. */
export function keepDrawn(page: Page): Promise<unknown> {
  return page.addInitScript(() => {
    const drawn = new Set<string>(),
      { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text: string, ...at: [number, number]) {
      drawn.add(text);
      fillText.call(this, text, ...at);
    };
    Object.assign(window, { drawn });
  });
}

/**
 * Every visible text and every name for those who cannot see it, shadow trees included, and every text drawn since the
 * last time.
 */
export function textsOf(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const { drawn = new Set<string>() } = window as unknown as { drawn?: Set<string> },
      texts = new Set<string>(drawn);
    drawn.clear();
    const visit = (node: Node): void => {
      if (node instanceof HTMLElement || node instanceof SVGElement) {
        if (["style", "script", "noscript", "kbd"].includes(node.localName)) return;
        if (node instanceof HTMLElement && !node.checkVisibility() && node.localName !== "option") return;
        for (const name of ["aria-label", "title", "placeholder", "aria-valuetext", "aria-description", "alt"]) {
          const text = node.getAttribute(name);
          if (text) texts.add(text.trim());
        }
        if (node.shadowRoot) visit(node.shadowRoot);
      }
      if (node.nodeType === Node.TEXT_NODE && node.textContent!.trim()) texts.add(node.textContent!.trim());
      node.childNodes.forEach(visit);
    };
    visit(document.body);
    return [...texts];
  });
}

export const english = (texts: readonly string[]): string[] =>
  texts.filter((text) => /[A-Za-z]{2,}/.test(text.replaceAll(NAMES, "").replace(CITED, "")));

export async function expectChinese(page: Page, where: string): Promise<void> {
  const texts = await textsOf(page);
  expect(texts.length, where).toBeGreaterThan(20);
  expect.soft(english(texts), where).toEqual([]);
}

export interface Inside extends PlaygroundElement {
  app: {
    complete(): Promise<unknown>;
    openPreset(id: string): void;
    catalog: { scenarios: { id: string }[]; planners: { id: string }[] };
  };
}

export const set = (page: Page, patch: Record<string, unknown>): Promise<void> =>
  page.evaluate((given) => document.querySelector<PlaygroundElement>("parkade-playground")!.store.set(given), patch);
