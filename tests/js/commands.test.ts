/** The page's commands: one key one command, each with a title in both languages and a row in the help. */
import { beforeAll, describe, expect, it, vi } from "vitest";
import { chordOf, commands, join, runChord, TOOLS, type CommandId } from "../../www/src/app/commands";
import { EDITING } from "../../www/src/app/edit-commands";
import { SECTIONS } from "../../www/src/app/help-rows";
import type { App } from "../../www/src/app/app";
import { isMessage, translate } from "../../www/src/i18n/index";
import "../../www/src/i18n/later";
import { createStore } from "../../www/src/store";
import { ToolController } from "../../www/src/tools/controller";
import { loadChinese } from "./chinese";

const press = (key: string, modifiers: Partial<KeyboardEvent> = {}) =>
  chordOf({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...modifiers } as KeyboardEvent);

join(EDITING);
const all = Object.entries(commands);

beforeAll(loadChinese);

describe("commands", () => {
  it("join the table with the drawing tools", () => {
    expect(all.length).toBe(Object.keys(TOOLS).length + Object.keys(EDITING).length + 13);
  });

  it("have keys of their own", () => {
    const keys = all.flatMap(([, command]) => command.keys);
    expect(new Set(keys).size).toBe(keys.length);
    expect(all.filter(([, command]) => command.keys.length === 0)).toEqual([]);
  });

  it("have titles in both languages", () => {
    for (const [id, { title }] of all) {
      expect(isMessage(title), id).toBe(true);
      expect(translate("zh", title), id).toMatch(/\p{Script=Han}/u);
    }
  });

  it("stand in the help, once each", () => {
    const rows = Object.values(SECTIONS).flat();
    const listed = rows.flat().filter((name) => name in commands);
    expect(listed.toSorted()).toEqual(Object.keys(commands).toSorted());
    for (const [first] of rows) expect(first in commands || isMessage(first!), first).toBe(true);
  });
});

describe("a chord", () => {
  it("reads as each system writes it", async () => {
    const { shownChord, ariaKeys } = await import("../../www/src/app/chord-text");
    expect(["Mod+Shift+Z", "Mod+ArrowLeft", "+", "-"].map(shownChord)).toEqual(["Ctrl Shift Z", "Ctrl ←", "+", "−"]);
    expect(ariaKeys(commands.redo!)).toBe("Control+Shift+Z Control+Y");
    vi.stubGlobal("navigator", { platform: "MacIntel" });
    vi.resetModules();
    const mac = await import("../../www/src/app/chord-text");
    vi.unstubAllGlobals();
    expect(["Mod+Shift+Z", "Mod+Z", "V"].map(mac.shownChord)).toEqual(["⇧ ⌘ Z", "⌘ Z", "V"]);
    expect(mac.ariaKeys(commands.undo!)).toBe("Meta+Z");
  });

  it("takes Ctrl and ⌘ alike, and Shift with them", () => {
    expect(press("z", { ctrlKey: true })).toBe("Mod+Z");
    expect(press("z", { metaKey: true })).toBe("Mod+Z");
    expect(press("Z", { metaKey: true, shiftKey: true })).toBe("Mod+Shift+Z");
    expect(press("ArrowLeft", { ctrlKey: true, shiftKey: true })).toBe("Mod+Shift+ArrowLeft");
  });

  it("is the character where Shift makes another", () => {
    expect(press("?", { shiftKey: true })).toBe("?");
    expect(press("V", { shiftKey: true })).toBe("V");
    expect(press("v", { altKey: true })).toBeNull();
  });

  const app = async () => {
    const store = createStore(),
      controller = new ToolController(store);
    await controller.fetchTools();
    return { store, controller, ask: vi.fn(), cycleMode: vi.fn() } as unknown as App;
  };

  it("runs its command, and leaves other keys alone", async () => {
    const one = await app();
    expect(runChord(one, "B")).toBe(true);
    expect(one.store.state.tool).toBe("brush");
    expect(runChord(one, "\\")).toBe(true);
    expect(one.cycleMode).toHaveBeenCalledOnce();
    expect(runChord(one, "?")).toBe(true);
    expect(one.ask).toHaveBeenCalledWith("keys");
    expect(runChord(one, "W")).toBe(false);
  });

  it("of an edit with nothing to edit keeps its usual meaning", async () => {
    const one = await app();
    expect(runChord(one, "Delete")).toBe(false);
    one.store.set({ selection: { kind: "start" } });
    const { heading } = one.store.state.scene.start as { heading: number };
    expect(runChord(one, "Mod+ArrowLeft")).toBe(true);
    expect((one.store.state.scene.start as { heading: number }).heading).toBeCloseTo(heading + Math.PI / 36, 12);
  });

  it("of a command that is not enabled is used up", async () => {
    const one = await app();
    const undo = commands["undo" satisfies CommandId]!;
    expect(undo.isEnabled!(one.store.state)).toBe(false);
    expect(runChord(one, "Mod+Z")).toBe(true);
    expect(one.store.state.canRedo).toBe(false);
  });
});
