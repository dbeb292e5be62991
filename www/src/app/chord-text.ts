/** Chords as people and assistive technology read them. */
import { translate, type Lang } from "../i18n/index";
import "../i18n/later";
import type { Command } from "./command";

const isMac = /^(Mac|iP)/.test(globalThis.navigator?.platform ?? "");
/** In the order in which each system writes them. */
const SHOWN: Readonly<Record<string, string>> = {
  Mod: isMac ? "⌘" : "Ctrl",
  Shift: isMac ? "⇧" : "Shift",
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
  Delete: "Del",
  Backspace: "⌫",
  "-": "−",
};

/** `Ctrl Shift Z`, and `⇧ ⌘ Z` on a Mac. */
export function shownChord(chord: string): string {
  const parts = chord.split(/\+(?=.)/).map((part) => SHOWN[part] ?? part);
  const isSwapped = isMac && parts[1] === SHOWN.Shift;
  return (isSwapped ? [parts[1], parts[0], ...parts.slice(2)] : parts).join(" ");
}

/** For `aria-keyshortcuts`. */
export const ariaKeys = ({ keys }: Command): string =>
  keys.map((chord) => chord.replace("Mod", isMac ? "Meta" : "Control")).join(" ");

/** The title with its keys, as a tooltip has it. */
export const tooltip = (lang: Lang, { title, keys }: Command): string =>
  `${translate(lang, title)} · ${keys.map(shownChord).join(" / ")}`;
