import fc from "fast-check";
import { beforeAll, expect, test } from "vitest";
import {
  ParkadeError,
  Planner,
  checkPath,
  defaultConfig,
  init,
  planners,
  scenario,
  scenarios,
  sceneGeometry,
  type Scenario,
} from "parkade";

/** Errors that callers can cause; "internal" is none of them. */
const CODES = ["bad-config", "bad-scenario", "bad-vehicle", "bad-input", "unknown-planner", "unknown-scenario"];

/** An answer, or a ParkadeError that says whose fault it is. */
function answersOrExplains(run: () => unknown) {
  try {
    run();
  } catch (error) {
    expect(error).toBeInstanceOf(ParkadeError);
    expect(CODES).toContain((error as ParkadeError).code);
    expect((error as ParkadeError).message).not.toBe("");
  }
}

const untyped = (value: unknown) => value as never;

const number = fc.oneof(
  fc.double({ min: -100, max: 100 }),
  fc.constantFrom(0, -0, 1e-300, 1e9, 1e300, -1, 2 ** 31, 2 ** 53, Infinity, -Infinity, NaN),
);
const value = fc.oneof(number, fc.constantFrom(null, undefined, true, "", "hybrid", 10n, () => 0), fc.anything());

/** A copy of `whole` with one of its fields, at any depth, replaced. */
function damaged(whole: object, choices: number[], by: unknown): object {
  const copy = structuredClone(whole);
  let at = copy as Record<string, unknown>;
  for (const [depth, choice] of choices.entries()) {
    const keys = Object.keys(at);
    const key = keys[choice % keys.length];
    if (key === undefined) break;
    const inner = at[key];
    if (typeof inner !== "object" || inner === null || depth === choices.length - 1) {
      at[key] = by;
      break;
    }
    at = inner as Record<string, unknown>;
  }
  return copy;
}

const choices = fc.array(fc.nat(50), { minLength: 1, maxLength: 5 });

/** The smallest preset: fuzzing is about the border, not about long searches. */
function smallest(): Scenario {
  const cells = ({ map }: Scenario) => map.width * map.height;
  return scenarios()
    .map(({ id }) => scenario(id))
    .reduce((best, other) => (cells(other) < cells(best) ? other : best));
}

beforeAll(() => init());

test("any value for a scene is geometry or an explained error", () => {
  fc.assert(fc.property(value, (scene) => answersOrExplains(() => sceneGeometry(untyped(scene)))), { numRuns: 500 });
});

test("a preset with one damaged field is geometry or an explained error", () => {
  const scenes = scenarios().map(({ id }) => scenario(id));
  fc.assert(
    fc.property(fc.constantFrom(...scenes), choices, value, (scene, path, by) =>
      answersOrExplains(() => sceneGeometry(damaged(scene, path, by) as Scenario)),
    ),
    { numRuns: 2000 },
  );
});

test("settings with one damaged field prepare a planner or are explained", () => {
  const scene = smallest();
  const ids = planners().map(({ id }) => id);
  fc.assert(
    fc.property(fc.constantFrom(...ids), choices, value, (id, path, by) =>
      answersOrExplains(() => new Planner(id, scene, untyped(damaged(defaultConfig(id), path, by))).free()),
    ),
    { numRuns: 500 },
  );
});

test("any path is checked or explained", () => {
  const scene = smallest();
  const path = fc.oneof(fc.array(number, { maxLength: 30 }), value);
  const directions = fc.oneof(fc.constant(undefined), fc.array(fc.constantFrom(-1, 1, 0, 128)), value);
  fc.assert(
    fc.property(path, directions, (poses, signs) =>
      answersOrExplains(() => checkPath(scene, untyped(poses), untyped(signs))),
    ),
    { numRuns: 1000 },
  );
});

test("options, layers and ids of any kind are answered or explained", () => {
  const planner = new Planner("four", smallest());
  fc.assert(
    fc.property(value, (any) => {
      answersOrExplains(() => planner.plan(untyped(any)));
      answersOrExplains(() => planner.layer(untyped(any)));
      answersOrExplains(() => scenario(untyped(any)));
      answersOrExplains(() => defaultConfig(untyped(any)));
      answersOrExplains(() => new Planner(untyped(any), smallest()).free());
    }),
    { numRuns: 100 },
  );
  planner.free();
});
