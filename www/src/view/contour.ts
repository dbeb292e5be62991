/** Contours of a raster as closed polygons (marching squares), in cell units with cell centres at whole numbers. */

/**
 * Traces where `value(x, y)` reaches `level`; outside the raster the value is `outside`. Every loop keeps the side
 * at or above the level on its left, so all loops together fill by the non-zero rule.
 */
export function contours(
  width: number,
  height: number,
  value: (x: number, y: number) => number,
  level: number,
  outside = -Infinity,
): number[][] {
  const at = (x: number, y: number): number => (x < 0 || y < 0 || x >= width || y >= height ? outside : value(x, y));
  const stride = width + 2;
  // An edge is named by its cell corner and whether it goes east (0) or north (1).
  const next = new Map<number, { to: number; x: number; y: number }>();
  const name = (x: number, y: number, north: number): number => 2 * ((y + 1) * stride + x + 1) + north;
  const share = (a: number, b: number): number =>
    Number.isFinite(a) && Number.isFinite(b) && a !== b ? clamp01((level - a) / (b - a)) : 0.5;
  for (let y = -1; y < height; y++) {
    for (let x = -1; x < width; x++) {
      const sw = at(x, y),
        se = at(x + 1, y),
        ne = at(x + 1, y + 1),
        nw = at(x, y + 1);
      const kind = (sw >= level ? 1 : 0) | (se >= level ? 2 : 0) | (ne >= level ? 4 : 0) | (nw >= level ? 8 : 0);
      if (kind === 0 || kind === 15) continue;
      const points = [
        { id: name(x, y, 0), x: x + share(sw, se), y },
        { id: name(x + 1, y, 1), x: x + 1, y: y + share(se, ne) },
        { id: name(x, y + 1, 0), x: x + share(nw, ne), y: y + 1 },
        { id: name(x, y, 1), x, y: y + share(sw, nw) },
      ];
      for (const [from, to] of SEGMENTS[kind]!)
        next.set(points[from]!.id, { to: points[to]!.id, x: points[from]!.x, y: points[from]!.y });
    }
  }
  return follow(next);
}

/** Per corner pattern (SW 1, SE 2, NE 4, NW 8): from edge to edge (S 0, E 1, N 2, W 3), inside on the left. */
const SEGMENTS: readonly (readonly (readonly [number, number])[])[] = [
  [],
  [[0, 3]],
  [[1, 0]],
  [[1, 3]],
  [[2, 1]],
  [
    [0, 3],
    [2, 1],
  ],
  [[2, 0]],
  [[2, 3]],
  [[3, 2]],
  [[0, 2]],
  [
    [1, 0],
    [3, 2],
  ],
  [[1, 2]],
  [[3, 1]],
  [[0, 1]],
  [[3, 0]],
  [],
];

function follow(next: Map<number, { to: number; x: number; y: number }>): number[][] {
  const loops: number[][] = [];
  for (const start of [...next.keys()]) {
    const loop: number[] = [];
    for (let step = next.get(start), id = start; step; step = next.get(id)) {
      loop.push(step.x, step.y);
      next.delete(id);
      id = step.to;
    }
    if (loop.length > 4) loops.push(loop);
  }
  return loops;
}

const clamp01 = (t: number): number => Math.min(1, Math.max(0, t));
