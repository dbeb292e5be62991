/** Painted cells, which cost more to cross: areas of one weight each, apart from each other. */
import type { CostArea } from "./scenario";
import { sameRuns, subtractRuns, unionRuns, type Run } from "./cells";
import { nextId, withCosts, type Scene } from "./model";

/** Gives cells this weight, whatever they had; 1 takes the paint away. The same object where nothing changes. */
export function paintCosts(scene: Scene, cells: readonly Run[], weight: number): Scene {
  const { costs = [] } = scene,
    own = weight > 1 ? costs.find((area) => area.weight === weight) : undefined;
  let changed = false;
  const put = (area: CostArea, runs: Run[]): CostArea[] => {
    if (sameRuns(runs, area.runs)) return [area];
    changed = true;
    return runs.length > 0 ? [{ ...area, runs }] : [];
  };
  const next = costs.flatMap((area) =>
    put(area, area === own ? unionRuns(area.runs, cells) : subtractRuns(area.runs, cells)),
  );
  if (weight > 1 && !own && cells.length > 0) {
    changed = true;
    next.push({ id: nextId(scene, "cost"), runs: unionRuns(cells, []), weight });
  }
  return changed ? withCosts(scene, next) : scene;
}

/** An area's weight as a number of fields; areas of one weight become one. */
export function reweigh(scene: Scene, id: string, weight: number): Scene {
  const area = scene.costs?.find((one) => one.id === id);
  if (!area || area.weight === weight) return scene;
  if (weight === 1 || scene.costs!.some((one) => one.weight === weight)) return paintCosts(scene, area.runs, weight);
  return withCosts(
    scene,
    scene.costs!.map((one) => (one === area ? { ...area, weight } : one)),
  );
}

const sorted = new WeakMap<readonly CostArea[], Map<number, number>>();

/** The weight at a cell. */
export function weightAt({ costs, map }: Scene, index: number): number {
  if (!costs?.length) return 1;
  let cells = sorted.get(costs);
  if (!cells) {
    cells = new Map();
    for (const { runs, weight } of costs) {
      for (const [x, y, count] of runs)
        for (let i = y * map.width + x, end = i + count; i < end; i++)
          cells.set(i, Math.max(weight, cells.get(i) ?? 1));
    }
    sorted.set(costs, cells);
  }
  return cells.get(index) ?? 1;
}
