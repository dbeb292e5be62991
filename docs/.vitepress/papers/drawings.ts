/** Figures that show no scene: diagrams of the papers, as SVG. */
import type { Explanation } from "parkade";
import { Planner, scenario } from "../../../pkg/node.js";

const opened = (width: number, height: number): string =>
  `<svg xmlns="http://www.w3.org/2000/svg" ` +
  `width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" font-family="system-ui, ` +
  `sans-serif" font-size="14">`;

/** Sectors around a cell, by the slopes at which they end, and the name of each, from the east to the left. */
function sectors(middle: number, radius: number, ends: readonly number[], names: readonly string[]): string {
  const at = (angle: number, by: number): string =>
    `${(middle + by * Math.cos(angle)).toFixed(1)} ${(radius + 12 - by * Math.sin(angle)).toFixed(1)}`;
  return names
    .map((name, i) => {
      const end = ends[i]!,
        inside = (end + (ends[(i + names.length - 1) % names.length]! - (i === 0 ? 2 * Math.PI : 0))) / 2;
      const [x, y] = at(inside, radius * 0.72).split(" ");
      return (
        `<path d="M${at(0, 0)}L${at(end, radius)}" stroke="#64696F" stroke-dasharray="4 3"/><text ` +
        `x="${x}" y="${Number(y) + 5}" text-anchor="middle" font-weight="600">${name}</text>`
      );
    })
    .join("");
}

/** Figure 3: the regions of tables 1 and 2 by the force's slope. */
export function regionsPicture(): string {
  const third = Math.atan(1 / 3),
    quarter = Math.PI / 4,
    radius = 120;
  const oblique = Array.from({ length: 8 }, (_, i) => i * quarter + (i % 2 === 0 ? third : quarter - third));
  const straight = Array.from({ length: 4 }, (_, i) => quarter + 2 * i * quarter);
  const frame = (middle: number): string =>
    `<circle cx="${middle}" cy="${radius + 12}" r="${radius}" fill="#F4F5F3" stroke="#3F444B"/>`;
  return (
    `${opened(540, 290)}${frame(135)}${sectors(135, radius, oblique, [
      "1",
      "2",
      "3",
      "4",
      "5",
      "6",
      "7",
      "8",
    ])}${frame(405)}${sectors(405, radius, straight, ["A", "B", "C", "D"])}<g text-anchor="middle" font-size="12" ` +
    `fill="#3F444B"><text x="135" y="275">k = ±1/3, ±3</text><text x="405" y="275">k = ±1</text></g></svg>`
  );
}

/** Figure 4: the cells that the planner itself tries around one, all of them free: three, and those beyond them. */
export function expansionPicture(): string {
  const scene = scenario("fig8-30"),
    planner = new Planner("risk-field", scene),
    side = 34;
  const tried = ({ candidates }: Explanation) => candidates.filter(({ role }) => role !== "held-back");
  const open = (region: string): Explanation => {
    for (let y = 2; y < scene.map.height - 2; y++)
      for (let x = 2; x < scene.map.width - 2; x++) {
        const found = planner.explain({ x, y });
        if (found?.region === region && tried(found).every(({ free }) => free)) return found;
      }
    throw new Error(`no cell of region ${region} is open`);
  };
  const panel = (region: string, i: number): string => {
    const found = open(region),
      left = 10 + i * (5 * side + 20);
    const box = (x: number, y: number, fill: string, mark: string): string =>
      `<rect x="${left + x * side}" y="${10 + (4 - y) * side}" width="${side}" height="${side}" fill="${fill}" ` +
      `stroke="#8A8F96"/><text x="${left + (x + 0.5) * side}" y="${10 + (4.5 - y) * side + 5}" ` +
      `text-anchor="middle">${mark}</text>`;
    const grid = Array.from({ length: 25 }, (_, k) => box(k % 5, Math.floor(k / 5), "#fff", ""));
    const cells = tried(found).map(({ cell, role }) =>
      box(
        cell[0] - found.cell[0] + 2,
        cell[1] - found.cell[1] + 2,
        role === "primary" ? "#BFE3D6" : "#F2C37B",
        role === "primary" ? "" : "+",
      ),
    );
    return (
      `${grid.join("")}${cells.join("")}${box(2, 2, "#1B1D20", "")}<text x="${left + 2.5 * side}" ` +
      `y="${5 * side + 30}" text-anchor="middle" font-weight="600">${region}</text>`
    );
  };
  try {
    return `${opened(3 * 190 + 10, 5 * side + 40)}${["1", "2", "A"].map(panel).join("")}</svg>`;
  } finally {
    planner.free();
  }
}

/** Figure 7: five steering angles in each gear, half a turning radius long. */
export function steeringPicture(): string {
  const [wheelbase, most] = [3.7, 0.6],
    long = 2.7,
    scale = 44;
  const arc = (share: number, gear: 1 | -1): string => {
    const radius = wheelbase / Math.tan(Math.abs(share) * most),
      turn = long / radius;
    const [x, y] =
      share === 0 ? [long, 0] : [radius * Math.sin(turn), Math.sign(share) * radius * (1 - Math.cos(turn))];
    const end = `${(150 + gear * x * scale).toFixed(1)} ${(100 - y * scale).toFixed(1)}`;
    const way =
      share === 0
        ? `L${end}`
        : `A${(radius * scale).toFixed(1)} ${(radius * scale).toFixed(1)} 0 0 ${share * gear > 0 ? 0 : 1} ${end}`;
    return (
      `<path d="M150 100${way}" fill="none" ` +
      `stroke="${gear > 0 ? "#0072B2" : "#D55E00"}" stroke-width="2"/><circle ` +
      `cx="${end.split(" ")[0]}" cy="${end.split(" ")[1]}" r="3.5" fill="${gear > 0 ? "#0072B2" : "#D55E00"}"/>`
    );
  };
  return `${opened(300, 200)}${([1, -1] as const)
    .flatMap((gear) => [-1, -0.5, 0, 0.5, 1].map((share) => arc(share, gear)))
    .join("")}<circle cx="150" cy="100" r="4.5" fill="#1B1D20"/></svg>`;
}

/** Figure 4: the volumes around a car that stands at 25°. */
export function volumesPicture(): string {
  const turn = (25 * Math.PI) / 180,
    [a, b] = [2.75, 1.3];
  const x = a * Math.cos(turn) + b * Math.sin(turn),
    y = a * Math.sin(turn) + b * Math.cos(turn);
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="320" height="320" viewBox="-3.4 -3.4 6.8 6.8" ` +
    `role="img"><circle r="${Math.hypot(a, b)}" fill="none" stroke="#CC79A7" stroke-width="0.05" ` +
    `stroke-dasharray="0.05 0.12" stroke-linecap="round"/><rect ` +
    `x="${-x}" y="${-y}" width="${2 * x}" height="${2 * y}" fill="none" stroke="#D55E00" stroke-width="0.05" ` +
    `stroke-dasharray="0.25 0.12"/><rect transform="rotate(-25)" ` +
    `x="${-a}" y="${-b}" width="${2 * a}" height="${2 * b}" fill="#1B1D20" fill-opacity="0.12" stroke="#0072B2" ` +
    `stroke-width="0.07"/></svg>`
  );
}

/** Layers below each other, each a name over a row of boxes, joined by arrows. */
export function layersPicture(layers: readonly (readonly [name: string, ...boxes: string[]])[]): string {
  const width = 640,
    tall = 74,
    gap = 26,
    height = layers.length * (tall + gap) - gap + 16;
  const escaped = (words: string): string => words.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
  const layer = ([name, ...boxes]: readonly [string, ...string[]], i: number): string => {
    const y = 8 + i * (tall + gap),
      wide = (width - 32) / boxes.length;
    const box = (words: string, at: number): string =>
      `<rect x="${(16 + at * wide + 4).toFixed(1)}" y="${y + 28}" width="${(wide - 8).toFixed(1)}" height="36" ` +
      `rx="4" fill="#fff" stroke="#8A8F96"/><text ` +
      `x="${(16 + (at + 0.5) * wide).toFixed(1)}" y="${y + 50}" text-anchor="middle">${escaped(words)}</text>`;
    return (
      `<rect x="8" y="${y}" width="${width - 16}" height="${tall}" rx="6" fill="#F4F5F3" ` +
      `stroke="#3F444B"/><text x="${width / 2}" y="${y + 19}" text-anchor="middle" ` +
      `font-weight="600">${escaped(name)}</text>${boxes.map(box).join("")}${
        i > 0 ? `<path d="M${width / 2} ${y - gap}V${y - 3}m-4 -5l4 5l4 -5" fill="none" stroke="#3F444B"/>` : ""
      }`
    );
  };
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" ` +
    `width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" font-family="system-ui, ` +
    `sans-serif" font-size="12">${layers.map(layer).join("")}</svg>`
  );
}

/** Boxes below each other, joined by arrows; after box `last` the way leads back to box `first`. */
export function flowPicture(steps: readonly string[], { first, last }: { first: number; last: number }): string {
  const width = 560,
    tall = 44,
    gap = 22,
    edge = 44;
  const top = (i: number): number => 8 + i * (tall + gap);
  const box = (step: string, i: number): string =>
    `<rect x="${edge}" y="${top(i)}" width="${width - edge - 20}" height="${tall}" rx="6" fill="#fff" ` +
    `stroke="#3F444B"/><text ` +
    `x="${(width + edge - 20) / 2}" y="${top(i) + 27}" text-anchor="middle">${step
      .replaceAll("&", "&amp;")
      .replaceAll("<", "&lt;")}</text>${
      i > 0 && i !== last + 1
        ? `<path d="M${(width + edge - 20) / 2} ${top(i) - gap}V${top(i) - 3}m-4 -5l4 5l4 -5" fill="none" ` +
          `stroke="#3F444B"/>`
        : ""
    }`;
  const back =
    `<path d="M${edge} ${top(last) + tall / 2}H18V${top(first) + tall / 2}H${edge - 3}m-5 -4l5 4l-5 4" ` +
    `fill="none" stroke="#3F444B"/>`;
  return `${opened(width, top(steps.length))}${steps.map(box).join("")}${back}</svg>`;
}

/** A car at a heading: lines and points of its own frame, metres ahead of the rear axle and to the left, as pixels. */
function carView(heading: number, origin: readonly [number, number], scale: number) {
  const [sin, cos] = [Math.sin(heading), Math.cos(heading)];
  const at = ([ahead, left]: readonly [number, number]): string =>
    `${(origin[0] + scale * (ahead * cos - left * sin)).toFixed(
      1,
    )} ${(origin[1] - scale * (ahead * sin + left * cos)).toFixed(1)}`;
  const line = (points: readonly (readonly [number, number])[], style: string): string =>
    `<path d="M${points.map(at).join("L")}" fill="none" ${style}/>`;
  const text = (words: string, place: readonly [number, number]): string => {
    const [x, y] = at(place).split(" ");
    return `<text x="${x}" y="${y}" text-anchor="middle">${words}</text>`;
  };
  return { at, line, text };
}
const INK = `stroke="#1B1D20" stroke-width="2"`,
  THIN = `stroke="#64696F" stroke-dasharray="4 3"`,
  BLUE = `stroke="#0072B2" stroke-width="2"`;
/** The paper's car: wheelbase, overhangs and width, metres. */
const CAR = { wheelbase: 3.7, front: 0.8, rear: 1, width: 2.6 } as const;
const body = (from = -CAR.rear, to = CAR.wheelbase + CAR.front, half = CAR.width / 2): [number, number][] => [
  [to, half],
  [to, -half],
  [from, -half],
  [from, half],
  [to, half],
];
const sub = (name: string, index: string): string => `${name}<tspan dy="4" font-size="10">${index}</tspan>`;

/** Figure 2: the two wheels that stand for four, and the circle on which they turn. */
export function kinematicsPicture(): string {
  const { wheelbase } = CAR,
    heading = 0.45,
    steer = 0.5,
    radius = wheelbase / Math.tan(steer);
  const { at, line, text } = carView(heading, [80, 150], 40);
  const wheel = (ahead: number, turn: number): string => {
    const [x, y] = [0.45 * Math.cos(turn), 0.45 * Math.sin(turn)];
    return line(
      [
        [ahead - x, -y],
        [ahead + x, y],
      ],
      `stroke="#1B1D20" stroke-width="9" stroke-linecap="round"`,
    );
  };
  const pole: [number, number] = [0, -radius];
  const parts = [
    line(
      [
        [-1.4, 0],
        [wheelbase + 2.2, 0],
      ],
      THIN,
    ),
    line(
      [
        [0, 0],
        [wheelbase, 0],
      ],
      INK,
    ),
    line([[0, 0], pole, [wheelbase, 0]], THIN),
    line(
      [
        [wheelbase, 0],
        [wheelbase + 1.9 * Math.cos(-steer), 1.9 * Math.sin(-steer)],
      ],
      BLUE,
    ),
    line(
      [
        [0, 0],
        [1.6, 0],
      ],
      BLUE,
    ),
    wheel(0, 0),
    wheel(wheelbase, -steer),
    ...[pole, [0, 0] as const, [wheelbase, 0] as const].map((p) => {
      const [x, y] = at(p).split(" ");
      return `<circle cx="${x}" cy="${y}" r="4" fill="#D55E00"/>`;
    }),
    text(`(${sub("x", "r")}<tspan dy="-4">, </tspan>${sub("y", "r")}<tspan dy="-4">)</tspan>`, [-0.35, 0.55]),
    text(`(${sub("x", "f")}<tspan dy="-4">, </tspan>${sub("y", "f")}<tspan dy="-4">)</tspan>`, [wheelbase - 0.3, 0.75]),
    text("L", [wheelbase / 2, 0.3]),
    text(sub("δ", "f"), [wheelbase + 1.5, -0.32]),
    text(sub("v", "f"), [wheelbase + 1.75, -1.35]),
    text(sub("v", "r"), [1.55, -0.5]),
    text("R", [0.35, -radius / 2]),
    text("φ", [-0.4, -0.33]),
  ];
  const [x, y] = at([-1.4, 0]).split(" ");
  return `${opened(360, 460)}<path d="M${x} ${y}h60" fill="none" ${THIN}/>${parts.join("")}</svg>`;
}

/** Figure 3: the corners of the body by the rear axle. */
export function cornersPicture(): string {
  const { wheelbase, front, rear, width } = CAR,
    half = width / 2;
  const { at, line, text } = carView(0.4, [90, 190], 44);
  const corners: [string, number, number][] = [
    ["A", wheelbase + front, half],
    ["B", wheelbase + front, -half],
    ["C", -rear, -half],
    ["D", -rear, half],
  ];
  const dots = [["", 0, 0] as const, ["", wheelbase, 0] as const, ...corners].map(([, ahead, left]) => {
    const [x, y] = at([ahead, left]).split(" ");
    return `<circle cx="${x}" cy="${y}" r="4" fill="#D55E00"/>`;
  });
  const [x, y] = at([0, 0]).split(" ");
  const parts = [
    `<path d="M${x} ${y}h110" fill="none" ${THIN}/>`,
    line(body(), INK),
    line(
      [
        [-rear, 0],
        [wheelbase + front + 0.8, 0],
      ],
      THIN,
    ),
    line(
      [
        [0, -half],
        [0, half],
      ],
      THIN,
    ),
    line(
      [
        [wheelbase, -half],
        [wheelbase, half],
      ],
      THIN,
    ),
    ...dots,
    ...corners.map(([name, ahead, left]) =>
      text(`<tspan font-weight="600">${name}</tspan>`, [ahead + Math.sign(ahead) * 0.3, left + Math.sign(left) * 0.3]),
    ),
    text("L", [wheelbase / 2, 0.2]),
    text(sub("L", "f"), [wheelbase + front / 2, -0.4]),
    text(sub("L", "r"), [-rear / 2, 0.2]),
    text("W/2", [wheelbase + front - 0.4, half / 2 + 0.05]),
    text("θ", [1.75, -0.48]),
  ];
  return `${opened(360, 290)}${parts.join("")}</svg>`;
}

/**
 * Figure 6: a body and a line of an obstacle, projected onto the line's normal: apart on the left, met on the right.
 */
export function separatingPicture(): string {
  const panel = (left: number, heading: number, up: number, verdict: "apart" | "meets"): string => {
    const { at } = carView(heading, [left + 70, 150 - up], 30);
    const corners = body()
      .slice(0, 4)
      .map((p) => at(p).split(" ").map(Number) as [number, number]);
    const wall = 205,
      axis = left + 16,
      ys = corners.map(([, y]) => y),
      [top, bottom] = [Math.min(...ys), Math.max(...ys)];
    const ink = verdict === "apart" ? "#009E73" : "#D55E00";
    return [
      `<path d="M${corners.map((p) => p.join(" ")).join("L")}Z" fill="#1B1D20" fill-opacity="0.1" ${INK}/>`,
      `<path d="M${left + 40} ${wall}h220" stroke="#1B1D20" stroke-width="4"/>`,
      `<path d="M${axis} 20V235" ${THIN}/>`,
      ...[top, bottom].map((y) => {
        const x = corners.find((p) => p[1] === y)![0];
        return `<path d="M${axis} ${y}H${x}" ${THIN}/>`;
      }),
      `<path d="M${axis} ${top}V${bottom}" stroke="#0072B2" stroke-width="6"/>`,
      `<circle cx="${axis}" cy="${wall}" r="6" fill="${ink}"/>`,
    ].join("");
  };
  return `${opened(580, 250)}${panel(0, 0.35, 0, "apart")}${panel(290, 0.35, -36, "meets")}</svg>`;
}
