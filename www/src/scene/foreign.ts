/** Scenes that come from outside: links, files, messages, storage, other pages. */
import type { SceneGeometry } from "parkade";
import type { Run } from "./cells";
import { ensureIds } from "./model";
import type { GivenScenario, Scenario } from "./scenario";
import { forPlanners } from "./large-scene";

/** The part of the planners' module that knows scenes. */
interface Module {
  sceneGeometry(scene: GivenScenario): SceneGeometry;
  packRuns(runs: readonly Run[]): string;
  unpackRuns(text: string): Run[];
}

/** What a page draws and edits within a frame: a few kilobytes of a link can hold far more. */
const MOST_THINGS = 2000,
  MOST_POINTS = 50_000,
  LONGEST_TEXT = 200;

/** The scene as the page keeps it; throws what is wrong with it. */
export function checkedScene(scene: GivenScenario, module: Module): Scenario {
  geometryOf(bounded(scene), module);
  return ensureIds(withRuns(withoutNulls(scene), module.unpackRuns));
}

export const geometryOf = (scene: GivenScenario, { sceneGeometry, packRuns }: Module): SceneGeometry =>
  sceneGeometry(forPlanners(scene, packRuns));

/** The same scene, unless it is larger than a page can draw. What is no scene at all is for the planners to refuse. */
export function bounded<Given extends GivenScenario>(scene: Given): Given {
  const lists = Object.entries(scene ?? {}).filter((entry): entry is [string, unknown[]] => Array.isArray(entry[1]));
  const things = lists.flatMap(([, list]) => list) as ({ id?: unknown; points?: unknown } | null)[];
  limit(lists.map(([key]) => key).join(" and "), "objects", things.length, MOST_THINGS);
  limit(
    "points",
    "points",
    things.reduce((sum, one) => sum + (Array.isArray(one?.points) ? one.points.length : 0), 0),
    MOST_POINTS,
  );
  for (const [field, text] of [["name", scene?.name], ...things.map((one) => ["id", one?.id] as const)] as const)
    if (typeof text === "string") limit(field, "characters", text.length, LONGEST_TEXT);
  return scene;
}

function limit(path: string, unit: string, count: number, most: number): void {
  if (count <= most) return;
  throw Object.assign(new Error(), {
    path,
    message: `${path}: must be at most ${most} ${unit}, got ${count}`,
    template: `must be at most {} ${unit}, got {}`,
    values: [most, count].map(String),
  });
}

/**
 * To the planners null is as good as absent, but not to the page; the same object where there is none. Settings may be
 * null.
 */
function withoutNulls<T>(value: T): T {
  if (typeof value !== "object" || value === null || (Array.isArray(value) && typeof value[0] !== "object"))
    return value;
  const entries = Object.entries(value),
    kept = entries
      .filter(([, one]) => one !== null)
      .map(([key, one]) => [key, key === "planners" || key === "runs" ? one : withoutNulls(one)] as const);
  if (kept.length === entries.length && kept.every(([, one], i) => one === entries[i]![1])) return value;
  return (Array.isArray(value) ? kept.map(([, one]) => one) : Object.fromEntries(kept)) as T;
}

/** The scene with its cells as runs, also where they came as texts. */
function withRuns(scene: GivenScenario, unpack: (text: string) => Run[]): GivenScenario {
  const unpacked = <T extends { runs: Run[] | string }>(one: T): T =>
    typeof one.runs === "string" ? { ...one, runs: unpack(one.runs) } : one;
  const { obstacles, costs } = scene,
    packed = [...(obstacles ?? []), ...(costs ?? [])].some((one) => "runs" in one && typeof one.runs === "string");
  return !packed
    ? scene
    : {
        ...scene,
        ...(obstacles ? { obstacles: obstacles.map((one) => (one.type === "cells" ? unpacked(one) : one)) } : {}),
        ...(costs ? { costs: costs.map(unpacked) } : {}),
      };
}
