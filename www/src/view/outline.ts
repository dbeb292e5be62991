/** Brushed cells as paths in metres. */
import type { MapFrame } from "parkade";
import { unionRuns, type Run } from "../scene/cells";
import { newPath } from "./surface";

export interface CellPaths {
  fill: Path2D;
  edge: Path2D;
}

/** The cells' area, and its edges without the lines between neighbours. */
export function cellPaths(cells: readonly Run[], { origin, resolution }: MapFrame): CellPaths {
  const fill = newPath(),
    edge = newPath();
  const x = (column: number): number => origin[0] + column * resolution;
  const y = (row: number): number => origin[1] + row * resolution;
  const ends = new Map<number, number[]>();
  for (const [column, row, count] of unionRuns(cells, [])) {
    fill.rect(x(column), y(row), count * resolution, resolution);
    for (const end of [column, column + count]) {
      edge.moveTo(x(end), y(row));
      edge.lineTo(x(end), y(row + 1));
      const list = ends.get(row);
      if (list) list.push(end);
      else ends.set(row, [end]);
    }
  }
  for (const row of new Set([...ends.keys()].flatMap((r) => [r, r + 1]))) {
    const between = exclusive(ends.get(row - 1) ?? [], ends.get(row) ?? []);
    for (const [from, to] of between) {
      edge.moveTo(x(from), y(row));
      edge.lineTo(x(to), y(row));
    }
  }
  return { fill, edge };
}

/** The symmetric difference of two rows of intervals: their sorted ends, taken in pairs. */
function exclusive(a: readonly number[], b: readonly number[]): [number, number][] {
  const ends = [...a, ...b].sort((p, q) => p - q);
  const pairs: [number, number][] = [];
  for (let i = 0; i + 1 < ends.length; i += 2) if (ends[i]! < ends[i + 1]!) pairs.push([ends[i]!, ends[i + 1]!]);
  return pairs;
}
