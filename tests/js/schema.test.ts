import { readFileSync } from "node:fs";
import Ajv from "ajv";
import { init, scenario, sceneGeometry, scenarios, type Scenario } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";

const file = new URL("../../src/scenario/scenario.schema.json", import.meta.url);
const validate = new Ajv({ strict: true, allowUnionTypes: true }).compile(JSON.parse(readFileSync(file, "utf8")));

beforeAll(() => init());

function accepted(scene: unknown): boolean {
  try {
    sceneGeometry(scene as Scenario);
    return true;
  } catch {
    return false;
  }
}

describe("the published schema", () => {
  it("accepts every built-in scene", () => {
    for (const { id } of scenarios()) expect(validate(scenario(id)), id).toBe(true);
  });

  it("accepts painted cells, in runs and packed", () => {
    for (const runs of [[[0, 0, 4]], "AE"]) {
      const painted = { ...scenario("perpendicular"), costs: [{ id: "cost-1", runs, weight: 3 }] };
      expect(validate(painted)).toBe(true);
      expect(accepted(painted)).toBe(true);
    }
  });

  it("refuses what the planners refuse for its form", () => {
    const scene = scenario("perpendicular");
    const broken: unknown[] = [
      { ...scene, version: 2 },
      { ...scene, color: "red" },
      { ...scene, start: { x: 1, y: 2 } },
      { ...scene, map: { ...scene.map, width: 5000 } },
      { ...scene, map: { ...scene.map, resolution: -1 } },
      { ...scene, vehicle: "truck" },
      { ...scene, goal: { slot: "slot-1", entry: "sideways" } },
      {
        ...scene,
        obstacles: [
          {
            type: "polygon",
            points: [
              [0, 0],
              [1, 1],
            ],
          },
        ],
      },
      { ...scene, obstacles: [{ type: "hole" }] },
      { ...scene, slots: [{ ...scene.slots![0], width: 0 }] },
      { ...scene, costs: [{ runs: [[0, 0, 1]], weight: 11 }] },
      { ...scene, costs: [{ runs: [[0, 0, 1]], weight: 1.5 }] },
      { ...scene, costs: [{ runs: [[0, 0, 1]] }] },
      { ...scene, costs: [{ runs: "?", weight: 2 }] },
    ];
    for (const candidate of broken) {
      expect(validate(candidate), JSON.stringify(candidate).slice(0, 80)).toBe(false);
      expect(accepted(candidate)).toBe(false);
    }
  });
});
