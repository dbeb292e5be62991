/**
 * True if the page around an element is light or dark: themes of documentation sites switch by attribute or class, not
 * by the reader's system.
 */
import { parseColour } from "../view/tokens";

export type Scheme = "light" | "dark";

/**
 * Attributes by which themes are switched: VitePress and Tailwind have classes, Docusaurus and Starlight `data-theme`,
 * Material for MkDocs its own.
 */
const ATTRIBUTES = [
  "data-theme",
  "data-bs-theme",
  "data-md-color-scheme",
  "data-color-scheme",
  "data-color-mode",
  "data-mode",
  "data-scheme",
];
/** Names of themes: `slate` is Material's, `coal`, `navy`, `ayu` and `rust` are mdBook's. */
const DARK = ["dark", "theme-dark", "dark-mode", "dark-theme", "slate", "coal", "navy", "ayu"];
const LIGHT = ["light", "theme-light", "light-mode", "light-theme", "default", "rust"];

/** Tells the scheme at once and whenever it changes. Returns how to stop. */
export function watchScheme(element: HTMLElement, tell: (scheme: Scheme) => void): () => void {
  let told: Scheme | null = null;
  const look = (): void => {
    const scheme = schemeAround(element);
    if (scheme !== told) tell((told = scheme));
  };
  const observer = new MutationObserver(look),
    system = matchMedia("(prefers-color-scheme: dark)");
  for (const one of ancestors(element)) observer.observe(one, { attributes: true });
  // A background may fade to its colour.
  document.addEventListener("transitionend", look);
  system.addEventListener("change", look);
  look();
  return () => {
    observer.disconnect();
    document.removeEventListener("transitionend", look);
    system.removeEventListener("change", look);
  };
}

/** The nearest word for it; else the page's declared `color-scheme`, else what it is painted on, else the system's. */
function schemeAround(element: HTMLElement): Scheme {
  const around = ancestors(element);
  const [parent = document.documentElement] = around;
  return (
    first(around, named) ??
    declared(getComputedStyle(parent).colorScheme) ??
    first(around, painted) ??
    (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light")
  );
}

/** From the parent outwards, out of shadow roots too. */
function ancestors(element: Element): Element[] {
  const root = element.getRootNode(),
    outer = element.parentElement ?? (root instanceof ShadowRoot ? root.host : null);
  return outer ? [outer, ...ancestors(outer)] : [];
}

function first<T>(elements: readonly Element[], look: (element: Element) => T | null): T | null {
  for (const element of elements) {
    const found = look(element);
    if (found !== null) return found;
  }
  return null;
}

function named(element: Element): Scheme | null {
  for (const name of [...ATTRIBUTES.map((attribute) => element.getAttribute(attribute)), ...element.classList]) {
    if (name === null) continue;
    if (DARK.includes(name)) return "dark";
    if (LIGHT.includes(name)) return "light";
  }
  return null;
}

const declared = (value: string): Scheme | null =>
  /^(only )?(light|dark)( only)?$/.test(value) ? (value.includes("dark") ? "dark" : "light") : null;

function painted(element: Element): Scheme | null {
  const text = getComputedStyle(element).backgroundColor,
    colour = parseColour(text);
  // Four numbers: a colour that is seen through.
  if (!colour || text.startsWith("rgba")) return null;
  const [r, g, b] = colour;
  return 0.2126 * r + 0.7152 * g + 0.0722 * b < 110 ? "dark" : "light";
}
