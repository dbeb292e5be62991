/** Scenes as files. */
import { refused } from "../i18n/refusal";
import type { GivenScenario, Scenario } from "./scenario";

/** A scene file as people read it: two spaces, a closing newline. */
export function sceneToFile(scene: GivenScenario): Blob {
  return new Blob([`${JSON.stringify(scene, null, 2)}\n`], { type: "application/json" });
}

/** A file's name after the scene's. */
export function fileName(scene: Scenario): string {
  const name = (scene.name ?? "")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");
  return name || "parkade-scene";
}

/** Only the outline of a scene is checked here; the planners check every field. */
export function checkScene(value: unknown): Scenario {
  if (!isRecord(value)) throw refused`This is not a scene: an object is expected.`;
  if (value["version"] !== 1) throw refused`This scene has a version this page does not read; 1 is expected.`;
  const map = value["map"];
  if (
    !isRecord(map) ||
    !isPair(map["origin"]) ||
    !isNumber(map["width"]) ||
    !isNumber(map["height"]) ||
    !isNumber(map["resolution"])
  ) {
    throw refused`This scene has no map: origin, width, height and resolution are expected.`;
  }
  if (!isPose(value["start"])) throw refused`This scene has no start pose: x, y and heading are expected.`;
  const goal = value["goal"];
  if (
    !isPose(goal) &&
    !Array.isArray(goal) &&
    !(isRecord(goal) && ["slot", "slots", "region"].some((key) => key in goal))
  ) {
    throw refused`This scene has no goal: a pose, a slot, or a set of them is expected.`;
  }
  for (const key of ["obstacles", "slots", "costs"]) {
    if (value[key] !== undefined && !Array.isArray(value[key])) throw refused`This scene's ${key} are not a list.`;
  }
  return value as unknown as Scenario;
}

type Fields = Record<string, unknown>;
const isRecord = (value: unknown): value is Fields =>
  typeof value === "object" && value !== null && !Array.isArray(value);
const isNumber = (value: unknown): value is number => typeof value === "number" && Number.isFinite(value);
const isPair = (value: unknown): boolean => Array.isArray(value) && value.length === 2 && value.every(isNumber);
const isPose = (value: unknown): boolean =>
  isRecord(value) && isNumber(value["x"]) && isNumber(value["y"]) && isNumber(value["heading"]);
