import { init, scenario, sceneGeometry, scenarios } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import { ensureIds, resolve } from "../../www/src/scene/model";
import { decodeScene, encodeScene } from "../../www/src/scene/link";
import type { Scenario, Slot } from "../../www/src/scene/scenario";

beforeAll(() => init());

/** The page resolves scenes by itself while something is dragged; the planners must see the same. */
function expectSame(scene: Scenario): void {
  const page = resolve(scene),
    planners = sceneGeometry(scene);
  for (const which of ["start", "goal"] as const) {
    expect(Math.hypot(page[which].x - planners[which].x, page[which].y - planners[which].y)).toBeLessThan(1e-9);
    expect(Math.cos(page[which].heading - planners[which].heading)).toBeCloseTo(1, 12);
  }
  expect(page.vehicle.minTurningRadius).toBeCloseTo(planners.vehicle.minTurningRadius, 9);
  expect(page.vehicle.rearToFront).toBe(planners.vehicle.rearToFront);
  expect(page.parked.length).toBe(planners.parkedCars.length);
  page.slots.forEach(({ outline }, i) =>
    outline.forEach(([x, y], k) => {
      expect(x).toBeCloseTo(planners.slots[i]![k]![0], 9);
      expect(y).toBeCloseTo(planners.slots[i]![k]![1], 9);
    }),
  );
}

describe("the page's geometry", () => {
  it("is the planners' in every scene of the catalogue", () => {
    for (const { id } of scenarios()) expectSame(ensureIds(scenario(id)));
  });

  it("is the planners' for slots of every kind, entered either way", () => {
    const map = { origin: [0, 0] as [number, number], width: 80, height: 60, resolution: 0.5 };
    const slot = (kind: Slot["kind"], lean: "left" | "right"): Slot => ({
      id: "s",
      kind,
      x: 20,
      y: 15,
      heading: 0.7,
      width: 2.8,
      length: 6.2,
      ...(kind === "angled" ? { angle: 1, lean } : {}),
      occupied: false,
    });
    for (const kind of ["perpendicular", "parallel", "angled"] as const) {
      for (const lean of ["left", "right"] as const) {
        for (const entry of ["reverse-in", "head-in"] as const) {
          expectSame({
            version: 1,
            map,
            obstacles: [],
            slots: [slot(kind, lean)],
            vehicle: "sedan",
            start: { x: 5, y: 5, heading: 1 },
            goal: { slot: "s", entry },
          });
        }
      }
    }
  });
});

describe("links", () => {
  it("carry every scene of the catalogue in 1900 characters", async () => {
    for (const { id } of scenarios()) {
      const scene = ensureIds(scenario(id)),
        text = await encodeScene(scene);
      expect(text.length, id).toBeLessThanOrEqual(1900);
      expect(await encodeScene(await decodeScene(text)), id).toBe(text);
      expect(sceneGeometry(await decodeScene(text)).vehicle, id).toEqual(sceneGeometry(scene).vehicle);
    }
  });
});
