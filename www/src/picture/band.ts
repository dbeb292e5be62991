/**
 * The band that a car stays in during many drives, along a straightened path between what stands beside it; SVG text.
 */
import type { Scenario } from "parkade";
import { nth } from "../scene/nth";

type Point = readonly [number, number];
type Segment = readonly [Point, Point];

const WIDTH = 900,
  LEFT = 34,
  /** Nothing farther than this is drawn, metres. */
  REACH = 7,
  CAR_WIDTH = 1.8;

/**
 * `band`: per metre of the path the points farthest left and right, x, y, x, y; drawn `across` times as large across as
 * along.
 */
export function bandPicture(scene: Scenario, band: Float64Array, title: string, across: number): string {
  const segments = edges(scene),
    count = band.length / 4,
    along = (WIDTH - LEFT - 8) / Math.max(1, count - 1),
    scale = along * across,
    middle = 22 + REACH * scale,
    height = middle + REACH * scale + 24;
  const rows = Array.from({ length: count }, (_, i) => row(band, i, segments));
  const x = (i: number): string => (LEFT + i * along).toFixed(1);
  const y = (left: number): string => (middle - left * scale).toFixed(1);
  const strip = (of: (one: Row) => readonly [number, number]): string =>
    `${rows.map((one, i) => `${x(i)},${y(of(one)[0])}`).join(" ")} ${[...rows.keys()]
      .reverse()
      .map((i) => `${x(i)},${y(of(nth(rows, i))[1])}`)
      .join(" ")}`;
  const half = CAR_WIDTH / 2;
  const shapes = [
    `<polygon points="${strip(({ left }) => [REACH, left])}" fill="currentColor" fill-opacity="0.22"/>`,
    `<polygon points="${strip(({ right }) => [-right, -REACH])}" fill="currentColor" fill-opacity="0.22"/>`,
    `<polygon points="${strip(({ spread }) => [spread + half, -spread - half])}" fill="#0072B2" fill-opacity="0.25"/>`,
    `<polygon points="${strip(({ spread }) => [spread, -spread])}" fill="#0072B2"/>`,
  ].join("");
  const ticks = [-6, -3, 0, 3, 6]
    .map((left) => `<text x="${LEFT - 6}" y="${Number(y(left)) + 4}" text-anchor="end">${left}</text>`)
    .join("");
  const metres = Array.from({ length: Math.floor(count / 100) + 1 }, (_, i) => 100 * i)
    .map(
      (at) =>
        `<text x="${x(at)}" y="${(height - 8).toFixed(1)}"${
          count - at < 40 ? ' text-anchor="end"' : ""
        }>${at} m</text>`,
    )
    .join("");
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 ` +
    `0 ${WIDTH} ${height.toFixed(0)}" width="${WIDTH}" height="${height.toFixed(0)}" role="img" ` +
    `aria-label="${title}" font-family="system-ui, sans-serif" font-size="11" fill="currentColor"><text ` +
    `x="${LEFT}" y="14" font-weight="600">${title}</text>${shapes}${ticks}${metres}</svg>`
  );
}

/** Metres: half the width of the band of middles, and what is free to both sides of its middle. */
interface Row {
  spread: number;
  left: number;
  right: number;
}

function row(band: Float64Array, i: number, segments: readonly Segment[]): Row {
  const at = (k: number): number => nth(band, 4 * i + k),
    [lx, ly, rx, ry] = [at(0), at(1), at(2), at(3)];
  const width = Math.hypot(lx - rx, ly - ry) || 1,
    to: Point = [(lx - rx) / width, (ly - ry) / width],
    from: Point = [(lx + rx) / 2, (ly + ry) / 2];
  return {
    spread: width / 2,
    left: free(from, to, segments),
    right: free(from, [-to[0], -to[1]], segments),
  };
}

/** How far a ray goes before it meets a segment. */
function free([x, y]: Point, [dx, dy]: Point, segments: readonly Segment[]): number {
  let nearest = REACH;
  for (const [[ax, ay], [bx, by]] of segments) {
    const [ex, ey] = [bx - ax, by - ay],
      cross = dx * ey - dy * ex;
    if (cross === 0) continue;
    const ray = ((ax - x) * ey - (ay - y) * ex) / cross,
      share = ((ax - x) * dy - (ay - y) * dx) / cross;
    if (ray >= 0 && ray < nearest && share >= 0 && share <= 1) nearest = ray;
  }
  return nearest;
}

function edges({ map, obstacles = [] }: Scenario): Segment[] {
  const closed = (points: readonly Point[]): Segment[] =>
    points.map((point, i) => [point, nth(points, (i + 1) % points.length)] as const);
  return [
    ...closed(map.boundary ?? []),
    ...obstacles.flatMap((one): Segment[] => {
      if (one.type === "polygon") return closed(one.points);
      if (one.type !== "rectangle") return [];
      const [cos, sin] = [Math.cos(one.heading ?? 0), Math.sin(one.heading ?? 0)];
      return closed(
        [
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([a, b]): Point => {
          const [u, v] = [(a! * one.size[0]) / 2, (b! * one.size[1]) / 2];
          return [one.center[0] + u * cos - v * sin, one.center[1] + u * sin + v * cos];
        }),
      );
    }),
  ];
}
