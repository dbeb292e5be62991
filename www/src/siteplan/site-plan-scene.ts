import type { Obstacle, Pose, Slot, VehicleSpec } from "parkade";
import type { Role, SitePlan, SitePlanLine, SitePlanOptions, SitePlanScene } from "parkade/siteplan";
import {
  boxOf,
  crossesItself,
  distance,
  fromPose,
  insidePolygon,
  segmentsMeet,
  type Box,
  type Point,
} from "../scene/geometry";
import type { Scenario } from "../scene/scenario";
import { poseInSlot } from "../scene/slots";
import { footprint, vehicleOf } from "../scene/vehicle";
import { findBays, largestGroup, slotsOf, type Quad, type Segment } from "./bays";
import { chained, straightened } from "./chain";
import { clippedLine, clippedPolygon } from "./clip";
import { SitePlanError } from "./site-plan";
import { lastIn, nth } from "../scene/nth";
import { rule } from "../i18n/rule";

export const ROLES = ["none", "wall", "kerb", "column", "building", "bay", "ground"] as const satisfies readonly Role[];

/** Ends that meet, and corners that are none, metres. */
const REACH = 0.02,
  STRAIGHT = 0.01;
const AROUND = 25,
  /** Beside the outermost thing, metres. */
  EDGE = 1,
  /** Before bays, where the plan ends with them. */
  AISLE = 7;
const WIDEST = 1000,
  MOST_OBSTACLES = 1900;

const anyOf = (...ways: RegExp[]): RegExp => new RegExp(ways.map((way) => way.source).join("|"), "i");

/**
 * Words in names of layers: those of the US National CAD Standard (`S-COLS`, `C-PKNG-STRP`), of OpenStreetMap, and of
 * plans in English, German, French, Spanish, Italian, Chinese, Japanese and Korean. The first role that fits counts.
 */
const NAMES: [Role, RegExp][] = [
  ["none", /(?:text|anno|dims?|ttlb|signs?)$|pkng[-_](?:cars|drai|isld|iden)/i],
  [
    "bay",
    anyOf(
      /(?:\b|_)parking[-_ ](?!lot|area|bound|outline)|(?:\b|_)pkng(?:\b|_)|\b(bay|stall|slot|space)s?\b|bays|stalls/,
      /stellpl|parkpl|parkst|stationnement|aparcamiento|estacionamiento|parcheggi|stallo|post[oi] auto/,
      /\u8f66\u4f4d|\u505c\u8f66|\u99d0\u8eca|\uc8fc\ucc28/,
    ),
  ],
  ["kerb", /kerb|curb|bord(?!er)|cordon|cordol|\u8def\u7f18|\u7f18\u77f3|\u7e01\u77f3|\uc5f0\uc11d/i],
  [
    "column",
    anyOf(
      /column|(?:\b|_)cols?(?:\b|_)|pillar|post\b|bollard|(?<!s)tree/,
      /st(?:\u00fc|ue)tze|poteau|pilar|pilastr|colonn|\u67f1|\uae30\ub465/,
    ),
  ],
  [
    "building",
    /build|bldg|geb(?:\u00e4|ae)ude|house|b[a\u00e2]timent|edifici|\u5efa\u7b51|\u5efa\u7269|\u697c|\uac74\ubb3c/i,
  ],
  ["wall", /wall|wand|mauer|fence|barrier|(?:\b|_)mur[ios]?(?:\b|_)|\bpared|\u5899|\u58c1|\ubcbd/i],
  ["ground", /amenity=parking$|(?:^|[^k])ground|floor|boundary|outline|site\b|grundst|\u8303\u56f4|\u573a\u5730/i],
];

export const suggestedRole = (name: string): Role => NAMES.find(([, words]) => words.test(name))?.[0] ?? "none";

/** A plan of fewer metres across holds no car and no way: its file names a wrong unit. */
const SMALLEST = 4;

/** Metres per unit that give the plan the size of a parking lot; what the file says where that can be. */
export function suggestedUnit(plan: SitePlan): number {
  const across = widthOf(plan),
    { metresPerUnit } = plan;
  if (metresPerUnit !== null && across * metresPerUnit >= SMALLEST) return metresPerUnit;
  const fitting = [1, 0.001, 0.01, 0.0254, 0.3048].find((unit) => across * unit >= 12 && across * unit <= 400);
  return fitting ?? Number((50 / across).toPrecision(3));
}

/** The longer side of a plan, in its units. */
export function widthOf({ layers }: SitePlan): number {
  const box = boxOf(layers.flatMap(({ lines }) => lines.flatMap(({ points }) => points)));
  return Math.max(box.maxX - box.minX, box.maxY - box.minY);
}

/** Throws `SitePlanError` where the choice gives no scene that fits. */
export function sceneFromSitePlan(plan: SitePlan, options: SitePlanOptions): SitePlanScene {
  const { metresPerUnit, around = AROUND, vehicle = "sedan" } = options;
  if (!(metresPerUnit > 0 && Number.isFinite(metresPerUnit)))
    throw new SitePlanError(rule`metresPerUnit: must be a positive number, got ${metresPerUnit}`);
  if (!(around >= 0 && Number.isFinite(around)))
    throw new SitePlanError(rule`around: must be at least 0 m, got ${around}`);
  const of = linesByRole(plan, options),
    found = findBays(of.bay),
    ground = groundOf(of.ground, found.quads),
    kept = ground || !isTooWide(boxOf(found.quads.flat())) ? found.quads : largestGroup(found.quads),
    window = windowOf(of, ground, kept.flat(), around);
  const solids = solidsOf(of, window);
  const bays = { ...found, quads: kept.filter((quad) => quad.some((corner) => isIn(corner, window))) };
  const slots = slotsOf(bays, solids.segments);
  const map = frameOf(ground, [...solids.segments.flat(), ...bays.quads.flat(), ...apronsOf(slots, solids.segments)]);
  const start = startFor(slots, solids, ground ?? cornersOf(map), vehicle);
  const goal =
    slots.length > 0
      ? { slot: nth(slots, Math.floor(slots.length / 2)).id!, entry: "reverse-in" as const }
      : aheadOf(start);
  const counts = { ...solids.counts, bay: slots.length, ground: ground ? 1 : 0 };
  return {
    scene: {
      version: 1,
      ...(options.name ? { name: options.name } : {}),
      map,
      obstacles: solids.obstacles,
      slots,
      vehicle,
      start,
      goal,
    },
    counts,
    notes: notesOf(plan, found.others, found.quads.length - bays.quads.length),
  };
}

type ByRole = Record<Exclude<Role, "none">, SitePlanLine[]>;

/** Lines in metres, the plan's lower left corner at the origin. */
function linesByRole({ layers }: SitePlan, { roles, metresPerUnit }: SitePlanOptions): ByRole {
  const of: ByRole = { wall: [], kerb: [], column: [], building: [], bay: [], ground: [] };
  for (const [name, role] of Object.entries(roles))
    if (!ROLES.includes(role))
      throw new SitePlanError(rule`roles[${JSON.stringify(name)}]: must be one of ${ROLES.join(", ")}`);
  const chosen = layers.filter(({ name }) => (roles[name] ?? "none") !== "none");
  if (chosen.length === 0) throw new SitePlanError(rule`roles: must give at least one layer of the plan a meaning`);
  const box = boxOf(chosen.flatMap(({ lines }) => lines.flatMap(({ points }) => points)));
  const placed = ([x, y]: Point): Point => [(x - box.minX) * metresPerUnit, (y - box.minY) * metresPerUnit];
  for (const { name, lines } of chosen)
    for (const { points, closed } of lines)
      of[roles[name] as keyof ByRole].push({ points: points.map(placed), closed });
  return of;
}

const isTooWide = ({ minX, minY, maxX, maxY }: Box): boolean => Math.max(maxX - minX, maxY - minY) > WIDEST;

/** The part of the plan that is kept: a map of a town is cut to one outline of the ground, or to one group of bays. */
function windowOf(of: ByRole, ground: readonly Point[] | null, bays: readonly Point[], around: number): Box {
  const outer = ground ?? bays,
    box = boxOf(
      outer.length > 0 ? [...outer] : Object.values(of).flatMap((lines) => lines.flatMap(({ points }) => points)),
    ),
    by = ground ? EDGE : around;
  if (isTooWide(box))
    throw new SitePlanError(
      rule`the plan must be at most ${WIDEST} m wide, and is ${Math.ceil(
        Math.max(box.maxX - box.minX, box.maxY - box.minY),
      )} m; choose another unit or fewer layers`,
    );
  return { minX: box.minX - by, minY: box.minY - by, maxX: box.maxX + by, maxY: box.maxY + by };
}

const isIn = ([x, y]: Point, box: Box): boolean => x >= box.minX && x <= box.maxX && y >= box.minY && y <= box.maxY;

interface Solids {
  obstacles: Obstacle[];
  segments: Segment[];
  areas: Point[][];
  counts: Record<"wall" | "kerb" | "column" | "building", number>;
}

function solidsOf(of: ByRole, window: Box): Solids {
  const solids: Solids = {
    obstacles: [],
    segments: [],
    areas: [],
    counts: { wall: 0, kerb: 0, column: 0, building: 0 },
  };
  for (const role of ["wall", "kerb", "column", "building"] as const)
    for (const line of chained(of[role], REACH)) {
      const isArea = line.closed && (role === "column" || role === "building"),
        area = isArea ? clippedPolygon(straightened(line.points, STRAIGHT, true), window) : [];
      if (isArea && area.length === 0) continue;
      if (isArea && area.length > 2 && !crossesItself(area))
        put(solids, role, { type: "polygon", points: area.map(rounded) });
      else {
        const points = line.closed ? [...line.points, nth(line.points, 0)] : line.points;
        for (const piece of clippedLine(straightened(points, STRAIGHT, false), window))
          put(solids, role, { type: "wall", points: piece.map(rounded), thickness: 0 });
      }
    }
  const { length } = solids.obstacles;
  if (length > MOST_OBSTACLES)
    throw new SitePlanError(
      rule`the chosen layers must have at most ${MOST_OBSTACLES} obstacles, and have ${length}; leave layers out`,
    );
  return solids;
}

function put(
  solids: Solids,
  role: keyof Solids["counts"],
  obstacle: Extract<Obstacle, { type: "polygon" | "wall" }>,
): void {
  const { points } = obstacle;
  solids.counts[role]++;
  solids.obstacles.push({ ...obstacle, id: `${role}-${solids.counts[role]}` });
  for (let i = 1; i < points.length; i++) solids.segments.push([nth(points, i - 1), nth(points, i)]);
  if (obstacle.type === "polygon") {
    solids.segments.push([lastIn(points), nth(points, 0)]);
    solids.areas.push(points);
  }
}

const rounded = ([x, y]: Point): Point => [Math.round(x * 1000) / 1000, Math.round(y * 1000) / 1000];

/** The closed outline with the most bays, the largest of several; null where all bays are elsewhere. */
function groundOf(lines: readonly SitePlanLine[], bays: readonly Quad[]): Point[] | null {
  const area = (points: readonly Point[]): number =>
    Math.abs(
      points.reduce(
        (sum, [x, y], i) =>
          sum + x * nth(points, (i + 1) % points.length)[1] - y * nth(points, (i + 1) % points.length)[0],
        0,
      ),
    ) / 2;
  const closed = chained(lines, REACH)
    .filter((line) => line.closed)
    .map(({ points }) => straightened(points, STRAIGHT, true).map(rounded))
    .filter((points) => points.length > 2 && !crossesItself(points));
  const held = new Map(
    closed.map((points) => [points, bays.filter(([corner]) => insidePolygon(corner, points)).length]),
  );
  const best = closed.sort((a, b) => held.get(b)! - held.get(a)! || area(b) - area(a))[0];
  return best && (bays.length === 0 || held.get(best)! > 0) ? best : null;
}

/** Places before bays where nothing is drawn, so that cars have an aisle. */
const apronsOf = (slots: readonly Slot[], segments: readonly Segment[]): Point[] =>
  slots.flatMap(({ x, y, heading }): Point[] => {
    const mouth = { x, y, heading },
      [near, far] = [fromPose(mouth, -REACH, 0), fromPose(mouth, -AISLE, 0)];
    return segments.some(([a, b]) => segmentsMeet(near, far, a, b)) ? [] : [far];
  });

function frameOf(ground: readonly Point[] | null, points: readonly Point[]): Scenario["map"] {
  if (!ground && points.length === 0) throw new SitePlanError(rule`the chosen layers hold nothing that a scene has`);
  const box = boxOf([...(ground ?? points)]),
    edge = ground ? 0 : EDGE,
    [x, y] = [Math.floor(box.minX - edge), Math.floor(box.minY - edge)],
    across = Math.max(box.maxX + edge - x, box.maxY + edge - y),
    resolution = across > 300 ? 1 : across > 100 ? 0.5 : 0.25;
  const cells = (to: number, from: number): number => Math.max(4, Math.ceil((to + edge - from) / resolution));
  return {
    origin: [x, y],
    width: cells(box.maxX, x),
    height: cells(box.maxY, y),
    resolution,
    ...(ground ? { boundary: [...ground] } : {}),
  };
}

const cornersOf = ({ origin: [x, y], width, height, resolution }: Scenario["map"]): Point[] => {
  const [right, top] = [x + width * resolution, y + height * resolution];
  return [
    [x, y],
    [right, y],
    [right, top],
    [x, top],
  ];
};

/**
 * In the aisle before a bay, along it, where the car overlaps nothing; in the middle of the ground where there is no
 * such place.
 */
function startFor(slots: readonly Slot[], solids: Solids, outline: readonly Point[], spec: VehicleSpec): Pose {
  const vehicle = vehicleOf(spec),
    parked = slots.map((slot) => footprint(poseInSlot(slot, "reverse-in", vehicle), vehicle));
  const isFree = (pose: Pose): boolean => {
    const body = footprint(pose, vehicle, 0.1);
    if (!body.every((corner) => insidePolygon(corner, outline))) return false;
    if (solids.areas.some((area) => insidePolygon(nth(body, 0), area) || insidePolygon(nth(area, 0), body)))
      return false;
    if (
      parked.some(
        (other) =>
          other.some((corner) => insidePolygon(corner, body)) || body.some((corner) => insidePolygon(corner, other)),
      )
    )
      return false;
    return !solids.segments.some(([a, b]) =>
      body.some((corner, i) => segmentsMeet(a, b, corner, nth(body, (i + 1) % 4))),
    );
  };
  for (const slot of slots)
    for (const [out, turn] of [3, 2.4, 1.8, 4, 5].flatMap((out) => [1, -1].map((turn) => [out, turn] as const))) {
      const mouth = { x: slot.x, y: slot.y, heading: slot.heading },
        [x, y] = fromPose(mouth, -out, 0),
        pose = { x, y, heading: slot.heading + (turn * Math.PI) / 2 };
      if (isFree(pose)) return pose;
    }
  const box = boxOf([...outline]),
    step = Math.max(2, Math.max(box.maxX - box.minX, box.maxY - box.minY) / 40);
  for (let x = box.minX + step; x < box.maxX; x += step)
    for (let y = box.minY + step; y < box.maxY; y += step)
      for (const heading of [0, Math.PI / 2]) if (isFree({ x, y, heading })) return { x, y, heading };
  throw new SitePlanError(rule`the chosen layers must leave room for a car to start`);
}

function aheadOf(start: Pose): Pose {
  const [x, y] = fromPose(start, 4, 0);
  return { x, y, heading: start.heading };
}

function notesOf({ notes }: SitePlan, others: number, elsewhere: number): string[] {
  return [
    ...notes,
    ...(others > 0 ? [`Outlines that are no bay: ${others}`] : []),
    ...(elsewhere > 0 ? [`Bays elsewhere, which are left out: ${elsewhere}`] : []),
  ];
}

/** Metres between two places of a plan, to set its scale by a known distance. */
export const unitFrom = (a: Point, b: Point, metres: number): number => metres / distance(a, b);
