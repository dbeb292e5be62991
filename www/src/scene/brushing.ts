/** Brushed cells: one obstacle that strokes add to and take from. */
import type { Obstacle } from "./scenario";
import { convexRuns, sameRuns, subtractRuns, unionRuns, type Run } from "./cells";
import { addObstacle, resolve, updateObstacle, type CellsObstacle, type Scene } from "./model";
import { footprint } from "./vehicle";

/** Adds brushed cells, never over the start or goal car, or erases them. The same object where nothing changes. */
export function brushCells(scene: Scene, cells: readonly Run[], mode: "add" | "erase"): Scene {
  return mode === "add" ? paintCells(scene, cells) : eraseCells(scene, cells);
}

function paintCells(scene: Scene, cells: readonly Run[]): Scene {
  const kept = subtractRuns(cells, keepClear(scene));
  if (kept.length === 0) return scene;
  const old = scene.obstacles?.find((o): o is CellsObstacle => o.type === "cells");
  if (!old) return addObstacle(scene, { type: "cells", runs: unionRuns(kept, []) }).scene;
  const runs = unionRuns(old.runs, kept);
  return sameRuns(runs, old.runs) ? scene : updateObstacle(scene, old.id, { ...old, runs });
}

function eraseCells(scene: Scene, cells: readonly Run[]): Scene {
  let changed = false;
  const obstacles = (scene.obstacles ?? []).flatMap((obstacle): Obstacle[] => {
    if (obstacle.type !== "cells") return [obstacle];
    const runs = subtractRuns(obstacle.runs, cells);
    if (sameRuns(runs, obstacle.runs)) return [obstacle];
    changed = true;
    return runs.length === 0 ? [] : [{ ...obstacle, runs }];
  });
  return changed ? { ...scene, obstacles } : scene;
}

/** Cells whose square can touch the start or goal body. */
export function keepClear(scene: Scene): Run[] {
  const { start, goal, vehicle } = resolve(scene);
  const margin = scene.map.resolution * Math.SQRT1_2;
  return [start, goal].flatMap((pose) => convexRuns(scene.map, footprint(pose, vehicle, margin)));
}
