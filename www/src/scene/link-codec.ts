import type {
  CostArea,
  Goal,
  GoalSet,
  Lane,
  MovingObstacle,
  Obstacle,
  Pose,
  Slot,
  SpeedLimit,
  VehicleSpec,
} from "parkade";
import type { Point } from "./geometry";
import type { GivenScenario, Scenario } from "./scenario";
import { nth } from "./nth";
import { refused } from "../i18n/refusal";

type Item = number | string | Item[] | Record<string, unknown> | null;

const cm = (metres: number): number => Math.round(metres * 100) + 0;
const tenths = (angle: number): number => Math.round((angle * 1800) / Math.PI) + 0;
const metres = (value: Item | undefined): number => number(value) / 100;
const angle = (value: Item | undefined): number => (number(value) * Math.PI) / 1800;

function number(value: Item | undefined): number {
  if (typeof value !== "number" || !Number.isFinite(value)) throw refused`This link is damaged: a number is missing.`;
  return value;
}
const pointOf = (x: Item | undefined, y: Item | undefined): Point => [metres(x), metres(y)];
function list(value: unknown): Item[] {
  if (!Array.isArray(value)) throw refused`This link is damaged: a list is missing.`;
  return value;
}

const packPose = (pose: Pose): Item[] => [cm(pose.x), cm(pose.y), tenths(pose.heading)];
const unpackPose = (item: Item[]): Pose => ({ x: metres(item[0]), y: metres(item[1]), heading: angle(item[2]) });

/** Centimetres with what is left of them: the lattice stays where it is. */
const cmExactly = (metres: number): number => Math.round(metres * 1e9) / 1e7 + 0;

/** To centimetres, but never off the map. */
function packBoundary({ origin, width, height, resolution }: Scenario["map"], points: readonly Point[]): number[] {
  const within = (value: number, k: 0 | 1): number =>
    Math.min(
      Math.floor((origin[k] + nth([width, height], k) * resolution) * 100 + 1e-6),
      Math.max(Math.ceil(origin[k] * 100 - 1e-6), cm(value)),
    ) / 100;
  return packPoints(points.map(([x, y]): Point => [within(x, 0), within(y, 1)]));
}

/** Differences from point to point are short and repeat, so they deflate well. */
function packPoints(points: readonly Point[]): number[] {
  let x = 0,
    y = 0;
  return points.flatMap((p) => {
    const step = [cm(p[0]) - x, cm(p[1]) - y];
    x += nth(step, 0);
    y += nth(step, 1);
    return step;
  });
}
function unpackPoints(items: Item[]): Point[] {
  const points: Point[] = [];
  for (let i = 0, x = 0, y = 0; i + 1 < items.length; i += 2) {
    x += number(items[i]);
    y += number(items[i + 1]);
    points.push([x / 100, y / 100]);
  }
  return points;
}

function packRuns(runs: readonly [number, number, number][]): number[] {
  let x = 0,
    y = 0;
  return runs.flatMap((run) => {
    const step = [run[0] - x, run[1] - y, run[2]];
    [x, y] = run;
    return step;
  });
}
function unpackRuns(items: Item[]): [number, number, number][] {
  const runs: [number, number, number][] = [];
  for (let i = 0, x = 0, y = 0; i + 2 < items.length; i += 3) {
    x += number(items[i]);
    y += number(items[i + 1]);
    runs.push([x, y, number(items[i + 2])]);
  }
  return runs;
}

/** Ids the page would give anyway are left out. */
const ownName = (id: string | undefined): string => (id === undefined || /^[a-z]+-\d+$/.test(id) ? "" : id);

function packObstacle(o: Obstacle): Item[] {
  const id = ownName(o.id);
  switch (o.type) {
    case "cells":
      return ["k", id, packRuns(o.runs)];
    case "wall":
      return ["w", id, packPoints(o.points), cm(o.thickness ?? 0)];
    case "road":
      return [
        "a",
        id,
        packPoints(o.points),
        [
          cm(o.radius ?? 20),
          ...(o.lanes ?? [1, 1]),
          cm(o.laneWidth ?? 3.5),
          cm(o.speed ?? 0),
          o.kerbs === false ? 0 : 1,
        ],
      ];
    case "polygon":
      return ["p", id, packPoints(o.points)];
    case "rectangle":
      return ["r", id, [...packPoints([o.center]), cm(o.size[0]), cm(o.size[1]), tenths(o.heading ?? 0)]];
    case "car":
      return ["c", id, packPose(o.pose), packVehicle(o.vehicle)];
  }
}

function unpackObstacle(item: Item): Obstacle {
  const [type, name, raw, extra] = list(item);
  const data = list(raw);
  const id = name ? { id: String(name) } : {};
  switch (type) {
    case "k":
      return { type: "cells", ...id, runs: unpackRuns(data) };
    case "w":
      return { type: "wall", ...id, points: unpackPoints(data), thickness: metres(extra) };
    case "a":
      return unpackRoad(id, unpackPoints(data), list(extra));
    case "p":
      return { type: "polygon", ...id, points: unpackPoints(data) };
    case "r":
      return {
        type: "rectangle",
        ...id,
        center: [metres(data[0]), metres(data[1])],
        size: [metres(data[2]), metres(data[3])],
        heading: angle(data[4]),
      };
    case "c":
      return { type: "car", ...id, pose: unpackPose(data), ...unpackVehicle(extra) };
    default:
      throw refused`This link is damaged: an obstacle of an unknown type.`;
  }
}

function unpackRoad(
  id: { id?: string },
  points: Point[],
  [radius, along, against, width, speed, kerbs]: Item[],
): Obstacle {
  return {
    type: "road",
    ...id,
    points,
    radius: metres(radius),
    lanes: [number(along), number(against)],
    laneWidth: metres(width),
    ...(speed ? { speed: metres(speed) } : {}),
    kerbs: kerbs === 1,
  };
}

const packVehicle = (vehicle: VehicleSpec | undefined): Item =>
  vehicle === undefined ? 0 : typeof vehicle === "string" ? vehicle : (vehicle as unknown as Record<string, unknown>);
const unpackVehicle = (item: Item | undefined): { vehicle?: VehicleSpec } =>
  item === 0 || item === undefined ? {} : { vehicle: item as VehicleSpec };

const KINDS = ["perpendicular", "parallel", "angled"] as const;

function packSlot(slot: Slot): Item[] {
  const base: Item[] = [
    KINDS.indexOf(slot.kind),
    cm(slot.x),
    cm(slot.y),
    tenths(slot.heading),
    cm(slot.width),
    cm(slot.length),
    slot.occupied ? 1 : 0,
    ownName(slot.id),
  ];
  return slot.kind === "angled" ? [...base, tenths(slot.angle ?? Math.PI / 4), slot.lean === "right" ? 1 : 0] : base;
}

function unpackSlot(item: Item): Slot {
  const [kind, x, y, heading, width, length, occupied, name, lean, side] = list(item);
  const word = KINDS[number(kind)];
  if (!word) throw refused`This link is damaged: a slot of an unknown kind.`;
  return {
    ...(name ? { id: String(name) } : {}),
    kind: word,
    x: metres(x),
    y: metres(y),
    heading: angle(heading),
    width: metres(width),
    length: metres(length),
    ...(word === "angled" ? { angle: angle(lean), lean: side === 1 ? ("right" as const) : ("left" as const) } : {}),
    occupied: occupied === 1,
  };
}

const packMoving = (one: MovingObstacle): Item[] => [
  packPoints(one.points),
  cm(one.size[0]),
  cm(one.size[1]),
  cm(one.speed),
  cm(one.start ?? 0),
  ownName(one.id),
];

function unpackMoving(item: Item): MovingObstacle {
  const [points, length, width, speed, start, name] = list(item);
  return {
    ...(name ? { id: String(name) } : {}),
    points: unpackPoints(list(points)),
    size: [metres(length), metres(width)],
    speed: metres(speed),
    start: metres(start),
  };
}

/** Roads are long: their headings and curvatures are kept to a millionth. */
const millionths = (value: number): number => Math.round(value * 1e6) + 0;

const packLane = ({ start, pieces, width, id }: Lane): Item[] => [
  cm(start.x),
  cm(start.y),
  millionths(start.heading),
  cm(width),
  pieces.flatMap(({ length, curvature = 0 }) => [cm(length), millionths(curvature)]),
  ownName(id),
];

function unpackLane(item: Item): Lane {
  const [x, y, heading, width, numbers, name] = list(item),
    flat = list(numbers),
    pieces: Lane["pieces"] = [];
  for (let i = 0; i + 1 < flat.length; i += 2)
    pieces.push({ length: metres(flat[i]), curvature: number(flat[i + 1]) / 1e6 });
  return {
    ...(name ? { id: String(name) } : {}),
    start: { x: metres(x), y: metres(y), heading: number(heading) / 1e6 },
    pieces,
    width: metres(width),
  };
}

const packLimit = ({ points, speed }: SpeedLimit): Item[] => [packPoints(points), cm(speed)];
function unpackLimit(item: Item): SpeedLimit {
  const [points, speed] = list(item);
  return { points: unpackPoints(list(points)), speed: metres(speed) };
}

const packCosts = ({ runs, weight, id }: CostArea): Item[] => [weight, packRuns(runs), ownName(id)];
function unpackCosts(item: Item): CostArea {
  const [weight, runs, name] = list(item);
  return { ...(name ? { id: String(name) } : {}), runs: unpackRuns(list(runs)), weight: number(weight) };
}

const ENTRIES = ["reverse-in", "head-in", "either"] as const;

/** One goal as numbers; a set begins with a letter. */
function packGoal({ goal, slots = [] }: Scenario): Item[] {
  const at = (id: string): number => slots.findIndex((slot) => slot.id === id);
  if (Array.isArray(goal)) return ["p", ...goal.map(packPose)];
  if ("slots" in goal) return ["s", ENTRIES.indexOf(goal.entry), goal.slots === "free" ? 0 : goal.slots.map(at)];
  if ("region" in goal) return ["r", packPoints(goal.region), goal.heading === undefined ? null : tenths(goal.heading)];
  return "slot" in goal ? [at(goal.slot), ENTRIES.indexOf(goal.entry)] : packPose(goal);
}

function unpackGoal(item: Item[], slots: readonly Slot[]): Goal | GoalSet {
  const [first, second, third] = item;
  const idAt = (at: Item | undefined): string => {
    const id = slots[number(at)]?.id;
    if (id === undefined) throw refused`This link is damaged: its goal slot is missing.`;
    return id;
  };
  switch (first) {
    case "p":
      return item.slice(1).map((pose) => unpackPose(list(pose)));
    case "s":
      return { slots: third === 0 ? "free" : list(third).map(idAt), entry: ENTRIES[number(second)] ?? "either" };
    case "r":
      return { region: unpackPoints(list(second)), ...(third === null ? {} : { heading: angle(third) }) };
    default:
      return item.length === 2
        ? { slot: idAt(first), entry: second === 1 ? "head-in" : "reverse-in" }
        : unpackPose(item);
  }
}

/** The short form; parts that are empty are left out. */
export function pack(scene: Scenario): Record<string, unknown> {
  const { map } = scene;
  return {
    m: [cmExactly(map.origin[0]), cmExactly(map.origin[1]), map.width, map.height, map.resolution],
    ...(map.boundary ? { b: packBoundary(map, map.boundary) } : {}),
    ...(scene.name ? { n: scene.name } : {}),
    ...(scene.obstacles?.length ? { o: scene.obstacles.map(packObstacle) } : {}),
    ...(scene.slots?.length ? { l: scene.slots.map(packSlot) } : {}),
    ...(scene.costs?.length ? { c: scene.costs.map(packCosts) } : {}),
    ...(scene.lanes?.length ? { r: scene.lanes.map(packLane) } : {}),
    ...(scene.speedLimits?.length ? { q: scene.speedLimits.map(packLimit) } : {}),
    ...(scene.moving?.length ? { d: scene.moving.map(packMoving) } : {}),
    ...(scene.vehicle !== undefined ? { v: scene.vehicle } : {}),
    s: packPose(scene.start),
    g: packGoal(scene),
    ...(scene.planners && Object.keys(scene.planners).length ? { p: scene.planners } : {}),
  };
}

export function unpack(data: Record<string, unknown>, name: (scene: GivenScenario) => Scenario): Scenario {
  const [x, y, width, height, resolution] = list(data["m"]);
  const bare = {
    version: 1 as const,
    ...(typeof data["n"] === "string" ? { name: data["n"] } : {}),
    map: {
      origin: pointOf(x, y),
      width: number(width),
      height: number(height),
      resolution: number(resolution),
      ...(data["b"] ? { boundary: unpackPoints(list(data["b"])) } : {}),
    },
    obstacles: list(data["o"] ?? []).map(unpackObstacle),
    slots: list(data["l"] ?? []).map(unpackSlot),
    ...(data["c"] ? { costs: list(data["c"]).map(unpackCosts) } : {}),
    ...(data["r"] ? { lanes: list(data["r"]).map(unpackLane) } : {}),
    ...(data["q"] ? { speedLimits: list(data["q"]).map(unpackLimit) } : {}),
    ...(data["d"] ? { moving: list(data["d"]).map(unpackMoving) } : {}),
    ...(data["v"] !== undefined ? { vehicle: data["v"] as VehicleSpec } : {}),
    start: unpackPose(list(data["s"])),
    goal: unpackPose([0, 0, 0]) as Goal,
    ...(data["p"] ? { planners: data["p"] as NonNullable<Scenario["planners"]> } : {}),
  };
  const named = name(bare);
  return { ...named, goal: unpackGoal(list(data["g"]), named.slots ?? []) };
}
