/** The table of commands. */
import type { State, ToolId } from "../store";
import type { IconName } from "../styles/icons";
import { ZOOM_STEP } from "../view/camera";
import type { App } from "./app";
import type { Command } from "./command";

const tool = (id: ToolId & IconName, ...keys: string[]): Command => ({
  keys,
  title: `tool.${id}`,
  icon: id,
  run: ({ store }) => store.set({ tool: id }),
});

/** In the order of the bars. */
export const TOOLS = {
  select: tool("select", "V", "1"),
  brush: tool("brush", "B", "2"),
  wall: tool("wall", "L", "3"),
  rectangle: tool("rectangle", "R", "4"),
  polygon: tool("polygon", "G", "5"),
  car: tool("car", "C", "6"),
  slot: tool("slot", "P", "7"),
  moving: tool("moving", "M"),
  road: tool("road", "D"),
  cost: tool("cost", "K", "8"),
  eraser: tool("eraser", "E", "9"),
  hand: tool("hand", "H"),
} satisfies Record<ToolId, Command>;

const FIRST = {
  ...TOOLS,
  undo: {
    keys: ["Mod+Z"],
    title: "bar.undo",
    icon: "undo",
    isEnabled: (state) => state.canUndo || state.transient,
    run: ({ store }) => store.undo(),
  },
  redo: {
    keys: ["Mod+Shift+Z", "Mod+Y"],
    title: "bar.redo",
    icon: "redo",
    isEnabled: (state) => state.canRedo,
    run: ({ store }) => store.redo(),
  },
  placeStart: { keys: ["S"], title: "keys.start", icon: "car", run: ({ controller }) => controller.arm("start") },
  placeGoal: { keys: ["T"], title: "keys.goal", icon: "car", run: ({ controller }) => controller.arm("goal") },
  play: { keys: ["A"], title: "keys.play", run: ({ player }) => player.toggle() },
  nextLayout: { keys: ["\\"], title: "keys.mode", run: (app) => app.cycleMode() },
  previousLayers: { keys: [","], title: "keys.layers", run: (app) => app.cycleLayers(-1) },
  nextLayers: { keys: ["."], title: "keys.layers", run: (app) => app.cycleLayers(1) },
  fit: { keys: ["0"], title: "bar.fit", icon: "fit", run: ({ controller }) => controller.fit() },
  zoomIn: { keys: ["+", "="], title: "view.in", run: ({ controller }) => controller.zoom(ZOOM_STEP) },
  zoomOut: { keys: ["-"], title: "view.out", run: ({ controller }) => controller.zoom(1 / ZOOM_STEP) },
  papers: { keys: ["Y"], title: "bar.papers", icon: "cells", run: (app) => app.ask("papers") },
  keys: { keys: ["?"], title: "bar.help", icon: "help", run: (app) => app.ask("keys") },
} satisfies Record<string, Command>;

type Editing = typeof import("./edit-commands").EDITING;
export type CommandId = keyof typeof FIRST | keyof Editing;

/** All commands that are loaded. */
export const commands: Partial<Record<CommandId, Command>> = { ...FIRST };

/** Those that edit come with the drawing tools. */
export function join(editing: Editing): void {
  Object.assign(commands, editing);
}

export const isEnabled = (state: State, { isEnabled }: Command): boolean => isEnabled?.(state) ?? true;

/** Runs the command of a chord: true where the key was used. */
export function runChord(app: App, chord: string): boolean {
  const command = Object.values(commands).find(({ keys }) => keys.includes(chord));
  if (!command) return false;
  return !isEnabled(app.store.state, command) || command.run(app) !== false;
}

/**
 * A key press as its modifiers and key: `Mod+Z`, `V`, `?`. `Mod` is Ctrl, and ⌘ on a Mac. Shift counts where it does
 * not make another character. Null with Alt, which belongs to the browser.
 */
export function chordOf({ key, ctrlKey, metaKey, altKey, shiftKey }: KeyboardEvent): string | null {
  if (altKey) return null;
  const isMod = ctrlKey || metaKey,
    name = key.length > 1 ? key : key.toUpperCase();
  return `${isMod ? "Mod+" : ""}${isMod && shiftKey ? "Shift+" : ""}${name}`;
}
