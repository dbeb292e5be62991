/** Scenes of very many cells: what is sent, checked and kept of them must not grow with every edit. */
import type { Run } from "./cells";
import type { GivenObstacle, GivenScenario } from "./scenario";

/** Runs of one obstacle beyond which it is handled as a whole. */
export const MANY = 2000;
/** Runs that take milliseconds to be made a text. */
const SLOW = 20_000;
/** No link is long enough for more. */
const LINKABLE = 20_000;

type CellsObstacle = Extract<GivenObstacle, { type: "cells" }>;

const texts = new WeakMap<readonly Run[], string>();
const sent = new WeakMap<readonly GivenObstacle[], GivenObstacle[]>();

/** Remembers what `pack` would make of these runs. */
export const rememberPacked = (runs: readonly Run[], text: string): void => void texts.set(runs, text);

/**
 * The scene for planners: many cells as a text, which is copied to a worker far faster; the same list for the same
 * obstacles.
 */
export function forPlanners(scene: GivenScenario, pack: (runs: readonly Run[]) => string): GivenScenario {
  const obstacles = scene?.obstacles ?? [],
    known = sent.get(obstacles);
  if (known) return { ...scene, obstacles: known };
  const packed = withCells(scene, (runs) => {
    const text = texts.get(runs) ?? pack(runs);
    texts.set(runs, text);
    // Only runs that make no sense give an empty text: the planners shall refuse them themselves.
    return text || runs;
  });
  if (packed !== scene) sent.set(obstacles, packed.obstacles!);
  return packed;
}

/** True if making that text would hold up a drag. */
export const isUnpacked = (scene: GivenScenario): boolean =>
  (scene.obstacles ?? []).some((one) => one.type === "cells" && one.runs.length > SLOW && !texts.has(one.runs));

/** The scene without many cells, for questions whose answer does not depend on them. */
export const withoutCells = (scene: GivenScenario): GivenScenario => withCells(scene, () => []);

export const countRuns = (scene: GivenScenario): number =>
  (scene.obstacles ?? []).reduce((sum, one) => sum + (one.type === "cells" ? one.runs.length : 0), 0);

export const fitsLink = (scene: GivenScenario): boolean => countRuns(scene) <= LINKABLE;

function withCells(scene: GivenScenario, change: (runs: Run[]) => string | Run[]): GivenScenario {
  // What comes from outside may be anything; the planners say what is wrong with it.
  const isMany = (one: GivenObstacle): one is CellsObstacle =>
    one?.type === "cells" && Array.isArray(one.runs) && one.runs.length > MANY;
  if (!Array.isArray(scene?.obstacles) || !scene.obstacles.some(isMany)) return scene;
  // The planners take such a text wherever they take runs.
  return {
    ...scene,
    obstacles: scene.obstacles.map((one) => (isMany(one) ? { ...one, runs: change(one.runs) as Run[] } : one)),
  };
}
