import { describe, expect, it } from "vitest";
import { createStore, UNDO_STEPS, type Scene } from "../../www/src/store";

const at = (scene: Scene, x: number): Scene => ({ ...scene, start: { ...scene.start, x } });

describe("undo", () => {
  it("takes back and repeats edits, scene only", () => {
    const store = createStore({});
    const first = store.state.scene;
    store.edit(at(first, 1));
    store.set({ camera: { x: 1, y: 2, scale: 3 } });
    store.edit(at(first, 2));
    store.undo();
    expect(store.state.scene.start.x).toBe(1);
    expect(store.state.camera).toEqual({ x: 1, y: 2, scale: 3 });
    expect([store.state.canUndo, store.state.canRedo]).toEqual([true, true]);
    store.undo();
    expect(store.state.scene).toBe(first);
    expect(store.state.canUndo).toBe(false);
    store.redo();
    store.redo();
    expect(store.state.scene.start.x).toBe(2);
    expect(store.state.canRedo).toBe(false);
  });

  it("makes one step of a drag", () => {
    const store = createStore({});
    const first = store.state.scene;
    for (let x = 1; x < 50; x++) store.edit(at(first, x), { transient: true });
    expect(store.state.transient).toBe(true);
    store.edit(at(first, 50));
    expect(store.state.transient).toBe(false);
    store.undo();
    expect(store.state.scene).toBe(first);
    expect(store.state.canUndo).toBe(false);
  });

  it("takes back a drag that is going on, without a step", () => {
    const store = createStore({});
    const first = store.state.scene;
    store.edit(at(first, 1), { transient: true });
    store.undo();
    expect([store.state.scene, store.state.transient, store.state.canUndo]).toEqual([first, false, false]);
  });

  it("keeps no step for a drag that ends where it began", () => {
    const store = createStore({});
    const first = store.state.scene;
    store.edit(at(first, 1), { transient: true });
    store.edit(first);
    expect(store.state.canUndo).toBe(false);
  });

  it("forgets what was undone after a new edit", () => {
    const store = createStore({});
    const first = store.state.scene;
    store.edit(at(first, 1));
    store.undo();
    store.edit(at(first, 2));
    expect(store.state.canRedo).toBe(false);
    store.redo();
    expect(store.state.scene.start.x).toBe(2);
  });

  it("holds hundreds of steps", () => {
    const store = createStore({});
    const first = store.state.scene;
    for (let x = 1; x <= UNDO_STEPS + 10; x++) store.edit(at(first, x));
    let steps = 0;
    while (store.state.canUndo) {
      store.undo();
      steps++;
    }
    expect(steps).toBe(UNDO_STEPS);
    expect(UNDO_STEPS).toBeGreaterThanOrEqual(200);
  });

  it("drops the selection of what undo removes", () => {
    const store = createStore({});
    const scene: Scene = {
      ...store.state.scene,
      obstacles: [
        {
          type: "wall",
          id: "wall1",
          points: [
            [0, 0],
            [1, 0],
          ],
        },
      ],
    };
    store.edit(scene);
    store.set({ selection: { kind: "obstacle", id: "wall1" } });
    store.undo();
    expect(store.state.selection).toBeNull();
  });
});

describe("listeners", () => {
  it("hear of changes with the state before, and of nothing else", () => {
    const store = createStore({});
    const heard: [string, string][] = [];
    const stop = store.subscribe((state, previous) => heard.push([previous.mode, state.mode]));
    store.set({ mode: "overlay" });
    store.set({ mode: "overlay" });
    stop();
    store.set({ mode: "grid" });
    expect(heard).toEqual([["grid", "overlay"]]);
  });
});

describe("a scene that is opened", () => {
  it("is counted, also when undo and redo come to it, and edits are not", () => {
    const store = createStore({});
    const count = () => store.state.opened;
    const first = store.state.scene,
      other = at(first, 9);
    store.edit(at(first, 1));
    store.edit(at(first, 2), { transient: true });
    store.edit(at(first, 3));
    expect(count()).toBe(0);
    store.set({ playback: { ...store.state.playback, playing: true, fraction: 0.4 } });
    store.edit(other, { label: "open" });
    expect(count()).toBe(1);
    expect(store.state.playback).toMatchObject({ playing: false, fraction: 1 });
    store.edit(at(other, 10));
    store.undo();
    expect(count()).toBe(1);
    store.undo();
    expect([count(), store.state.scene.start.x]).toEqual([2, 3]);
    store.undo();
    store.redo();
    expect(count()).toBe(2);
    store.redo();
    expect([count(), store.state.scene]).toEqual([3, other]);
    store.redo();
    expect(count()).toBe(3);
    const { history } = store;
    store.restore({ past: [...history.past], scene: history.scene, future: [...history.future] });
    expect(count()).toBe(4);
  });
});
