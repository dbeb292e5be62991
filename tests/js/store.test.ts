import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { createStore, UNDO_STEPS, WITHOUT_FRAME_MS, type Scene } from "../../www/src/store";
import { inNextFrame } from "../../www/src/store/animation-frame";
import { ToolController } from "../../www/src/tools/controller";

/** Of a canvas, what the tools' controller asks of it. */
class FakeCanvas {
  readonly style: Record<string, string> = {};
  readonly clientWidth = 400;
  readonly clientHeight = 300;
  private readonly handlers = new Map<string, (event: unknown) => void>();

  addEventListener(type: string, handler: (event: unknown) => void): void {
    this.handlers.set(type, handler);
  }
  setPointerCapture(): void {}
  getBoundingClientRect(): object {
    return { left: 0, top: 0, width: 400, height: 300 };
  }
  send(type: string, x: number, y: number): void {
    const event = {
      type,
      pointerId: 1,
      pointerType: "mouse",
      button: 0,
      clientX: x,
      clientY: y,
      offsetX: x,
      offsetY: y,
    };
    this.handlers.get(type)!({ ...event, timeStamp: 0, getCoalescedEvents: () => [event], preventDefault: () => {} });
  }
}

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

describe("notifications", () => {
  it("follow each other without gaps, also where a listener changes the state", () => {
    const store = createStore({}),
      heard: string[] = [];
    store.subscribe((state) => {
      if (state.mode === "focus" && state.follow === false) store.set({ follow: true });
    });
    store.subscribe((state, previous) =>
      heard.push(`${previous.mode} ${previous.follow} > ${state.mode} ${state.follow}`),
    );
    store.set({ mode: "focus" });
    expect(heard).toEqual(["grid false > focus false", "focus false > focus true"]);
    expect(store.state.follow).toBe(true);
  });

  it("of a batch are one, with the last state, and none where nothing is left of it", () => {
    const store = createStore({}),
      heard: unknown[] = [];
    store.subscribe((state, previous) => heard.push([previous.mode, state.mode, state.hover]));
    store.batch(() => {
      store.set({ mode: "focus" });
      store.batch(() => store.set({ hover: { x: 1, y: 2 } }));
      expect(store.state.mode).toBe("focus");
      expect(heard).toEqual([]);
    });
    expect(heard).toEqual([["grid", "focus", { x: 1, y: 2 }]]);
    store.batch(() => {});
    expect(heard).toHaveLength(1);
  });

  it("bring along what is derived from a change", () => {
    const store = createStore({}),
      heard: string[] = [];
    store.subscribe(({ mode, follow }, previous) =>
      heard.push(`${previous.mode} ${previous.follow} > ${mode} ${follow}`),
    );
    const stop = store.derive(({ mode }) => store.set({ follow: mode === "focus" }));
    store.set({ mode: "focus" });
    store.set({ mode: "overlay" });
    stop();
    store.set({ mode: "focus" });
    expect(heard).toEqual(["grid false > focus true", "focus true > overlay false", "overlay false > focus false"]);
  });

  it("reach derivers with what other derivers have set", () => {
    const store = createStore({}),
      heard: string[] = [];
    store.derive(({ follow }) => store.set({ penSeen: follow }));
    store.derive(({ mode }) => store.set({ follow: mode === "focus" }));
    store.subscribe(({ mode, follow, penSeen }) => heard.push(`${mode} ${follow} ${penSeen}`));
    store.set({ mode: "focus" });
    expect(heard).toEqual(["focus true true"]);
  });

  it("go on after a listener or a batch has failed", () => {
    const store = createStore({}),
      heard: string[] = [];
    const stop = store.subscribe(() => {
      throw new Error("broken");
    });
    expect(() => store.set({ mode: "focus" })).toThrow("broken");
    stop();
    store.subscribe((state, previous) => heard.push(`${previous.mode} > ${state.mode}`));
    expect(() =>
      store.batch(() => {
        store.set({ mode: "overlay" });
        throw new Error("batch");
      }),
    ).toThrow("batch");
    store.set({ follow: true });
    expect(heard).toEqual(["focus > overlay"]);
  });

  it("of a brush stroke are one for all moves within a frame, and planners are asked at each", async () => {
    const store = createStore({ tool: "brush" }),
      controller = new ToolController(store),
      canvas = new FakeCanvas(),
      frames: (() => void)[] = [];
    vi.stubGlobal("requestAnimationFrame", (run: () => void) => frames.push(run));
    vi.stubGlobal("addEventListener", () => {});
    vi.stubGlobal("PointerEvent", Object);
    await controller.fetchTools();
    controller.attach(canvas as unknown as HTMLElement);
    let told = 0,
      asked = 0;
    store.derive(({ scene }, previous) => {
      if (scene !== previous.scene) asked++;
    });
    store.subscribe(() => told++);
    canvas.send("pointerdown", 150, 150);
    expect(told).toBeLessThanOrEqual(1);
    for (let step = 1; step <= 20; step++) {
      told = 0;
      canvas.send("pointermove", 148 + 4 * step, 150);
      canvas.send("pointermove", 150 + 4 * step, 150);
      expect(told, `moves ${step}`).toBe(0);
      const before = asked;
      for (const run of frames.splice(0)) run();
      expect([told, asked], `frame ${step}`).toEqual([1, before]);
      expect(store.state.transient).toBe(true);
    }
    expect(asked).toBeGreaterThan(5);
    told = 0;
    canvas.send("pointermove", 240, 150);
    canvas.send("pointerup", 240, 150);
    expect(told).toBe(1);
    for (const run of frames.splice(0)) run();
    expect(told).toBe(1);
    expect([store.state.transient, store.state.canUndo]).toEqual([false, true]);
    vi.unstubAllGlobals();
  });
});

describe("gathered changes", () => {
  let frames: (() => void)[] = [];
  const frame = (): void => frames.splice(0).forEach((run) => run());
  const setup = () => {
    const store = createStore({}),
      heard: string[] = [];
    store.subscribe((state, previous) => heard.push(`${previous.mode} ${previous.tool} > ${state.mode} ${state.tool}`));
    return { store, heard };
  };

  beforeEach(() => {
    vi.useFakeTimers();
    frames = [];
    vi.stubGlobal("requestAnimationFrame", (run: () => void) => frames.push(run));
  });
  afterEach(() => {
    vi.unstubAllGlobals();
    vi.useRealTimers();
  });

  it("are in the state at once, and told together in the next frame", () => {
    const { store, heard } = setup();
    store.gather({ mode: "focus" });
    store.gather({ tool: "brush" });
    expect([store.state.mode, store.state.tool, heard]).toEqual(["focus", "brush", []]);
    frame();
    expect(heard).toEqual(["grid select > focus brush"]);
    vi.runAllTimers();
    frame();
    expect(heard).toHaveLength(1);
  });

  it("are told with a change that does not wait, and not again", () => {
    const { store, heard } = setup();
    store.gather({ mode: "focus" });
    store.set({ tool: "brush" });
    expect(heard).toEqual(["grid select > focus brush"]);
    frame();
    vi.runAllTimers();
    expect(heard).toHaveLength(1);
  });

  it("are told without a frame where none comes, and in the next one from then on", () => {
    const { store, heard } = setup();
    store.gather({ mode: "focus" });
    vi.advanceTimersByTime(WITHOUT_FRAME_MS);
    expect(heard).toEqual(["grid select > focus select"]);
    store.gather({ tool: "brush" });
    frame();
    expect(heard).toEqual(["grid select > focus select", "focus select > focus brush"]);
    expect(frames).toEqual([]);
  });

  it("of a listener wait for the next frame", () => {
    const { store, heard } = setup();
    store.subscribe(({ mode }) => {
      if (mode === "focus") store.gather({ tool: "brush" });
    });
    store.set({ mode: "focus" });
    expect(heard).toEqual(["grid select > focus select"]);
    frame();
    expect(heard.at(-1)).toBe("focus select > focus brush");
  });

  it("are told before what is drawn in the same frame, once, and others are done where one fails", () => {
    const { store } = setup(),
      done: string[] = [];
    const draw = (): unknown => done.push(`draw ${store.state.mode}`);
    store.subscribe(() => inNextFrame(draw));
    inNextFrame(draw);
    store.gather({ mode: "focus" });
    inNextFrame(() => {
      throw new Error("broken");
    });
    inNextFrame(() => done.push("last"));
    expect(frame).toThrow("broken");
    frame();
    expect(done).toEqual(["draw focus", "last"]);
  });
});

describe("a drag that is given up", () => {
  it("leaves the scene as it was, and no step", () => {
    const store = createStore({}),
      first = store.state.scene;
    expect(store.cancelEdit()).toBe(false);
    store.edit(at(first, 3), { transient: true });
    expect(store.cancelEdit()).toBe(true);
    expect([store.state.scene, store.state.transient, store.state.canUndo]).toEqual([first, false, false]);
    store.edit(at(first, 4));
    expect(store.cancelEdit()).toBe(false);
    expect(store.state.scene.start.x).toBe(4);
  });
});
