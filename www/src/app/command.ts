import type { MessageKey } from "../i18n/index";
import type { State } from "../store";
import type { IconName } from "../styles/icons";
import type { App } from "./app";

/** What keys, bars, menus and the help offer, declared once. */
export interface Command {
  /** Chords as `chordOf` writes them. The first ones stand in tooltips. */
  keys: readonly string[];
  title: MessageKey;
  icon?: IconName;
  /** Absent for always. */
  isEnabled?(state: State): boolean;
  /** False where the command had nothing to do: its key then keeps its usual meaning. */
  run(app: App): unknown;
}
