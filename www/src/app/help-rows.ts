/** Rows of the help on keys: the commands, and what keys do beside them. */
import type { MessageKey } from "../i18n/index";
import { TOOLS, type CommandId } from "./commands";
import { keysOf } from "../scene/records";

/** Commands, or what else keys do. */
export type Entry = CommandId[] | [title: MessageKey, ...chords: string[]];

const ARROWS = "↑ ↓ ← →";
const EDIT: readonly Entry[] = [
  ["undo"],
  ["redo"],
  ["remove"],
  ["keys.escape", "Esc"],
  ["keys.nudge", ARROWS, "Shift"],
  ["duplicate"],
  ["keys.copy", "Alt"],
  ["selectAll"],
  ["keys.add", "Shift"],
  ["turnLeft", "turnRight"],
  ["turnLeftALittle", "turnRightALittle"],
  ["keys.type", "Enter"],
  ["placeStart"],
  ["placeGoal"],
  ["keys.draw", ARROWS, "Enter"],
  ["keys.snap", "Mod", "Shift"],
  ["flip"],
  ["lock"],
  ["smallerBrush", "largerBrush"],
  ["lowerCost", "higherCost"],
];
const VIEW: readonly Entry[] = [
  ["play"],
  ["keys.tens", "Shift"],
  ["nextLayout"],
  ["previousLayers", "nextLayers"],
  ["fit"],
  ["keys.pan", "keys.space"],
  ["zoomIn"],
  ["zoomOut"],
  ["keys.zoom", "keys.wheel"],
  ["papers"],
  ["keys"],
];
/** The rows of the help, by its headings. */
export const SECTIONS = {
  "keys.tools": keysOf(TOOLS).map((id): Entry => [id]),
  "keys.edit": EDIT,
  "keys.view": VIEW,
};
