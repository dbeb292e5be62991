import { describe, expect, it } from "vitest";
import { goalPose, poseInSlot, resolve } from "../../www/src/scene/model";
import { createStore, type Scene, type State } from "../../www/src/store";
import { BrushTool, EraserTool } from "../../www/src/tools/brush";
import type { Obstacle } from "../../www/src/scene/scenario";
import type { Draft } from "../../www/src/store/draft";
import { MovingTool, PolygonTool, RoadTool, WallTool } from "../../www/src/tools/line";
import { SelectTool } from "../../www/src/tools/select";
import { SlotTool } from "../../www/src/tools/slot";
import type { ToolContext, Input, Tool } from "../../www/src/tools/tool";
import { gripOf } from "../../www/src/view/pose-handle";

const yard: Scene = {
  version: 1,
  map: { origin: [0, 0], width: 120, height: 80, resolution: 0.25 },
  obstacles: [{ type: "rectangle", id: "box", center: [20, 15], size: [4, 2], heading: 0 }],
  slots: [{ id: "bay", kind: "perpendicular", x: 25, y: 6, heading: -Math.PI / 2, width: 3, length: 6 }],
  vehicle: "paper",
  start: { x: 4, y: 10, heading: 0 },
  goal: { x: 14, y: 5, heading: 0 },
};

function bench(initial: Partial<State> = {}): ToolContext & { draft: Draft | null } {
  const store = createStore({ scene: yard, ...initial });
  return {
    store,
    draft: null,
    canvas: null,
    view: { camera: { x: 15, y: 10, scale: 20 }, width: 600, height: 400 },
    show(draft) {
      this.draft = draft;
    },
    preview: (scene) => store.edit(scene, { transient: true }),
    commit: (scene, label) => store.edit(scene, { label }),
    revert: () => {
      if (store.state.transient) store.undo();
    },
    done: () => store.set({ tool: "select" }),
  };
}

const input = (x: number, y: number, more: Partial<Input> = {}): Input => ({
  at: [x, y],
  pixel: [x * 20, -y * 20],
  trail: [[x, y]],
  shift: false,
  alt: false,
  ctrl: false,
  touch: false,
  ...more,
});

function drag(tool: Tool, on: ToolContext, points: [number, number][], more: Partial<Input> = {}): void {
  tool.down?.(on, input(...points[0]!, more));
  for (const point of points.slice(1)) tool.move?.(on, input(...point, more));
  tool.up?.(on, input(...points.at(-1)!, more));
}

const steps = ({ store }: ToolContext): number => {
  let count = 0;
  for (; store.state.canUndo; count++) store.undo();
  return count;
};

describe("a drag", () => {
  it("moves the goal about its rear axle in one undo step", () => {
    const on = bench();
    drag(new SelectTool(), on, [
      [16, 5],
      [17, 7],
      [19, 8.5],
    ]);
    expect(goalPose(on.store.state.scene)).toEqual({ x: 17, y: 8.5, heading: 0 });
    expect(on.store.state.selection).toEqual({ kind: "goal" });
    expect(steps(on)).toBe(1);
    expect(on.store.state.scene).toBe(yard);
  });

  it("of the grip turns the goal, and snaps to 15 degrees unless Alt is held", () => {
    const { goal, vehicle } = resolve(yard),
      grip = gripOf(goal, vehicle),
      far = Math.hypot(grip[0] - goal.x, grip[1] - goal.y);
    const turned = (angle: number, alt: boolean): number => {
      const on = bench();
      drag(new SelectTool(), on, [grip, [goal.x + far * Math.cos(angle), goal.y + far * Math.sin(angle)]], { alt });
      return (goalPose(on.store.state.scene).heading * 180) / Math.PI;
    };
    expect(turned((43 * Math.PI) / 180, false)).toBeCloseTo(45, 6);
    expect(turned((43 * Math.PI) / 180, true)).toBeCloseTo(43, 1);
    expect(turned((38 * Math.PI) / 180, false)).toBeCloseTo(38, 1);
  });

  it("with Alt leaves a copy", () => {
    const on = bench();
    drag(
      new SelectTool(),
      on,
      [
        [20, 15],
        [22, 17],
      ],
      { alt: true },
    );
    const [first, second] = on.store.state.scene.obstacles as { center: [number, number] }[];
    expect(first!.center).toEqual([20, 15]);
    expect(second!.center).toEqual([22, 17]);
    expect(steps(on)).toBe(1);
  });

  it.each([
    ["a shape that is smaller than its grips as a whole", [0.4, 0.4], [20.95, 15.95], [0.4, 0.4]],
    ["a corner of a larger one", [4, 2], [20.5, 15.5], [5, 3]],
  ] as const)("moves %s", (_, size, center, after) => {
    const on = bench({
      scene: { ...yard, obstacles: [{ ...yard.obstacles![0]!, size: [...size] } as Obstacle] },
      selection: { kind: "obstacle", id: "box" },
    });
    const corner: [number, number] = [20 + size[0] / 2, 15 + size[1] / 2];
    drag(new SelectTool(), on, [corner, [corner[0] + 1, corner[1] + 1]]);
    expect(on.store.state.scene.obstacles![0]).toMatchObject({ center: [...center], size: [...after] });
  });

  it("that is given up leaves the scene as it was", () => {
    const on = bench();
    const tool = new SelectTool();
    tool.down(on, input(16, 5));
    tool.move(on, input(18, 8));
    expect(tool.cancel(on)).toBe(true);
    expect(on.store.state.scene).toBe(yard);
    expect(on.store.state.canUndo).toBe(false);
  });

  it("brings the goal into the nearest free slot within 1.2 m and 35 degrees, either way, and shows which", () => {
    const bays = [21, 24, 27].map((x, i) => ({
      id: `bay-${i}`,
      kind: "perpendicular" as const,
      x,
      y: 6,
      heading: -Math.PI / 2,
      width: 3,
      length: 6,
      occupied: i === 1,
    }));
    let seed = 5,
      snapped = 0,
      missed = 0;
    const random = (least: number, most: number): number =>
      least + (most - least) * ((seed = (seed * 48_271) % 2_147_483_647) / 2_147_483_647);
    for (let i = 0; i < 400; i++) {
      const at = { x: random(18, 29), y: random(-1, 8), heading: random(-Math.PI, Math.PI) };
      const scene: Scene = { ...yard, slots: bays, goal: { ...at, x: at.x - 8 } },
        on = bench({ scene });
      const there = bays
        .filter((bay) => !bay.occupied)
        .flatMap((bay) =>
          (["reverse-in", "head-in"] as const).map((entry) => ({
            slot: bay.id,
            entry,
            pose: poseInSlot(bay, entry, resolve(scene).vehicle),
          })),
        )
        .map((one) => ({
          ...one,
          away: Math.hypot(one.pose.x - at.x, one.pose.y - at.y),
          turned: Math.abs(
            Math.atan2(Math.sin(one.pose.heading - at.heading), Math.cos(one.pose.heading - at.heading)),
          ),
        }))
        .filter(({ away, turned }) => away <= 1.2 && turned <= (35 * Math.PI) / 180)
        .sort((a, b) => a.away - b.away)[0];
      const tool = new SelectTool();
      const moveTo = (ctrl: boolean): Scene => {
        tool.down(on, input(at.x - 8, at.y));
        tool.move(on, input(at.x - 4, at.y, { ctrl }));
        tool.move(on, input(at.x, at.y, { ctrl }));
        return on.store.state.scene;
      };
      const { goal } = moveTo(false);
      expect(on.draft?.hot ?? null).toEqual(there ? { kind: "slot", id: there.slot } : null);
      tool.up(on, input(at.x, at.y));
      if (there) expect(goal).toEqual({ slot: there.slot, entry: there.entry });
      else expect("slot" in goal).toBe(false);
      on.store.undo();
      expect("slot" in moveTo(true).goal).toBe(false);
      if (there) snapped++;
      else missed++;
    }
    expect(Math.min(snapped, missed)).toBeGreaterThan(10);
  });

  it("brings the goal to rest in a slot close by; a click puts it there at once", () => {
    const on = bench();
    const there = { slot: "bay", entry: "reverse-in" };
    drag(new SelectTool(), on, [
      [25, 3],
      [25, 3],
    ]);
    expect(on.store.state.scene.goal).toEqual(there);
  });
});

describe("the brush", () => {
  it("draws one undo step and passes on what the browser held back between events", () => {
    const on = bench();
    const tool = new BrushTool();
    tool.down(on, input(2, 18));
    tool.move(
      on,
      input(28, 18, {
        trail: [
          [8, 19],
          [15, 17],
          [28, 18],
        ],
      }),
    );
    tool.up(on, input(28, 18));
    const cells = on.store.state.scene.obstacles!.find((o) => o.type === "cells")!;
    const columns = new Set(cells.runs.flatMap(([x, , count]) => Array.from({ length: count }, (_, i) => x + i)));
    expect(columns.size).toBeGreaterThanOrEqual(104);
    expect(cells.runs.some(([, y]) => y === Math.floor(19 / 0.25))).toBe(true);
    expect(steps(on)).toBe(1);
  });

  it("turned round takes cells and shapes away", () => {
    const on = bench();
    drag(new BrushTool(), on, [
      [2, 18],
      [10, 18],
    ]);
    drag(new EraserTool(), on, [
      [1, 18],
      [11, 18],
      [20, 16.2],
    ]);
    expect(on.store.state.scene.obstacles).toEqual([]);
    expect(steps(on)).toBe(2);
  });
});

describe("corner by corner", () => {
  const click = (tool: Tool, on: ToolContext, x: number, y: number): void => drag(tool, on, [[x, y]]);

  it("walls end with Enter", () => {
    const on = bench();
    const tool = new WallTool();
    for (const [x, y] of [
      [1, 1],
      [3, 1],
      [3, 4],
    ] as const)
      click(tool, on, x, y);
    expect(tool.confirm(on)).toBe(true);
    expect(on.store.state.scene.obstacles!.at(-1)).toMatchObject({
      type: "wall",
      points: [
        [1, 1],
        [3, 1],
        [3, 4],
      ],
    });
  });

  it("polygons close on their first corner and refuse one that would cross", () => {
    const on = bench();
    const tool = new PolygonTool();
    for (const [x, y] of [
      [1, 1],
      [5, 1],
      [5, 4],
    ] as const)
      click(tool, on, x, y);
    click(tool, on, 3, 0.25);
    expect(on.store.state.message).toEqual({ tone: "err", text: "This corner would cross an edge." });
    click(tool, on, 1, 4);
    click(tool, on, 1, 1);
    expect(on.store.state.scene.obstacles!.at(-1)).toMatchObject({
      type: "polygon",
      points: [
        [1, 1],
        [5, 1],
        [5, 4],
        [1, 4],
      ],
    });
    expect(on.store.state.tool).toBe("select");
  });
});

describe("a slot row", () => {
  it("lies where there is room for it and its aisle, and on the other side with Alt", () => {
    const south = -Math.PI / 2,
      headings = (points: [number, number][], alt = false): number[] => {
        const on = bench();
        drag(new SlotTool(), on, points, { alt });
        return [...new Set(on.store.state.scene.slots!.slice(1).map(({ heading }) => Math.round(heading * 1e6) / 1e6))];
      };
    const rounded = (angle: number): number => Math.round(angle * 1e6) / 1e6;
    // Along the upper wall the ground is below, whichever way one draws; along the lower one it is above.
    for (const [y, away] of [
      [19.5, south],
      [0.5, -south],
    ] as const) {
      for (const points of [
        [
          [2, y],
          [14, y],
        ],
        [
          [14, y],
          [2, y],
        ],
      ] as [number, number][][]) {
        expect(headings(points)).toEqual([rounded(away)]);
        expect(headings(points, true)).toEqual([rounded(-away)]);
      }
    }
  });

  it("holds as many slots as its length gives, to the right of the drag", () => {
    const on = bench();
    drag(new SlotTool(), on, [
      [2, 18],
      [18.1, 18],
    ]);
    const row = on.store.state.scene.slots!.slice(1);
    expect(row).toHaveLength(5);
    for (const slot of row) expect(slot.heading).toBeCloseTo(-Math.PI / 2, 9);
    expect(row[0]!.x).toBeCloseTo(2 + 1.6, 9);
  });
});

describe("a line tool", () => {
  const corners = (tool: Tool, on: ToolContext, points: [number, number][]): boolean => {
    for (const point of points) {
      tool.down?.(on, input(...point));
      tool.up?.(on, input(...point));
    }
    return tool.confirm!(on);
  };
  const LINE: [number, number][] = [
    [2, 16],
    [10, 16],
    [18, 16],
  ];

  it.each([
    [new WallTool(), "wall", "obstacle"],
    [new RoadTool(), "road", "obstacle"],
    [new MovingTool(), undefined, "moving"],
  ] as const)("ends in one step with the new thing selected", (tool, type, kind) => {
    const on = bench();
    expect(corners(tool, on, LINE)).toBe(true);
    const { scene, selection, tool: next } = on.store.state;
    expect(scene.obstacles!.slice(1).map((one) => one.type)).toEqual(type ? [type] : []);
    expect(scene.moving?.length ?? 0).toBe(type ? 0 : 1);
    expect([selection?.kind, next, on.draft]).toEqual([kind, "select", null]);
    expect(steps(on)).toBe(1);
  });

  it("drops an open line of one corner, and keeps a polygon of two", () => {
    const on = bench(),
      polygon = new PolygonTool();
    expect(corners(new WallTool(), on, LINE.slice(0, 1))).toBe(false);
    expect(corners(polygon, on, LINE.slice(0, 2))).toBe(false);
    polygon.down(on, input(10, 19));
    expect(polygon.confirm(on)).toBe(true);
    expect(steps(on)).toBe(1);
  });

  it("takes back the corner at which a road cannot turn", () => {
    const on = bench(),
      road = new RoadTool();
    const sharp: [number, number][] = [...LINE, [18.5, 16.2], [10, 16.5]];
    expect(corners(road, on, sharp)).toBe(true);
    expect(on.store.state.message?.tone).toBe("err");
    expect([on.store.state.scene, steps(on)]).toEqual([yard, 0]);
  });
});
