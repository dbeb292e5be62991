import type { SearchTrace } from "parkade";
import { number, type Lang } from "../i18n/index";
import { SAMPLING_CODE, beginOf, sampleFate, sampleLine, samplingOf } from "./sampling-steps";
import { FATE, STEP, type FateName, type SearchReplay } from "../planning/search-replay";
import { cost, placeOfStep, say, targetOf, type Key, type Role } from "./search-messages";
import { nth } from "../scene/nth";

/** What the last step did, in one sentence; or, of single moves, what the last event did. */
export function eventLine(lang: Lang, replay: SearchReplay, byMoves: boolean): string {
  const { step, trace } = replay,
    move = moveShown(replay, byMoves);
  if (step < 0) return say(lang, beginOf(replay));
  const place = placeOfStep(lang, replay, step);
  const side = replay.sides.length > 1 ? `${say(lang, replay.sideOf(step) === 1 ? "side.1" : "side.0")} · ` : "";
  if (move >= 0) return `${side}${place} → ${targetOf(lang, replay, move)}: ${fateText(lang, replay, move)}`;
  const values = {
    place,
    f: cost(lang, replay, nth(trace.f, step)),
    g: cost(lang, replay, nth(trace.g, step)),
    h: cost(lang, replay, nth(trace.h, step)),
  };
  const expanded = (): string => say(lang, "expand", { ...values, why: whyOf(lang, replay, step) });
  switch (replay.kindOf(step)) {
    case STEP.deferred:
      return side + say(lang, "deferred", values);
    case STEP.rejected:
      return side + say(lang, "rejected", values);
    case STEP.goal:
      return side + say(lang, "goal", values);
    case STEP.meet:
      return `${side}${trace.kind === "poses" ? `${expanded()} ${say(lang, "arcs.met")}` : say(lang, "meet", values)}`;
    case STEP.joined:
      return `${side}${expanded()} ${say(lang, "joined")}`;
    case STEP.drawn:
    case STEP.candidate:
      return sampleLine(lang, replay, step);
    default:
      return side + expanded();
  }
}

/** The move that is looked at; -1 where the step as a whole is. */
const moveShown = (replay: SearchReplay, byMoves: boolean): number =>
  byMoves || replay.at < replay.endOf(replay.step) ? replay.move : -1;

/** Why a step took its entry and no other. */
export function whyOf(lang: Lang, replay: SearchReplay, step: number): string {
  const { byF, byH } = replay.ties(step);
  if (byF > 0 && replay.trace.oldestFirst) return say(lang, "why.oldest", { n: byF });
  if (byF === 0) return say(lang, "why.only");
  return byH === 0 ? say(lang, "why.h", { n: byF }) : say(lang, "why.age", { n: byF, m: byH });
}

const FATE_KEYS: Record<FateName, Key> = {
  kept: "fate.kept",
  improved: "fate.improved",
  dearer: "fate.dearer",
  closed: "fate.closed",
  blocked: "fate.blocked",
  corner: "fate.corner",
  heldBack: "fate.heldBack",
  requeued: "fate.requeued",
  leftOut: "fate.leftOut",
  drawn: "fate.drawn",
};

/** What became of a move, and by what. */
export function fateText(lang: Lang, replay: SearchReplay, move: number): string {
  const fate = replay.fateOf(move),
    { trace } = replay;
  const target = nth(trace.targets, move),
    sampled = sampleFate(replay, fate);
  if (sampled) return say(lang, sampled);
  if (fate === "blocked" && trace.kind === "poses")
    return say(lang, "fate.hit", {
      thing: replay.nameOf(nth(trace.obstacles, move)),
      length: number(lang, Math.abs(nth(trace.arcs, 2 * move + 1)), 2),
    });
  if (fate === "requeued")
    return say(lang, "fate.requeued", {
      f: cost(lang, replay, nth(trace.targetG, move) + nth(trace.targetH, move) + trace.penalty),
    });
  if (fate === "improved" || fate === "dearer") {
    const before =
      fate === "improved" ? replay.costBefore(move) : replay.known(replay.sideOf(replay.stepOfMove(move)), target)?.g;
    return say(lang, FATE_KEYS[fate], {
      g: before === undefined || before === null ? "–" : cost(lang, replay, before),
    });
  }
  return say(lang, FATE_KEYS[fate]);
}

/** Micro-cells a cell. */
const UNIT = 1e6;

/**
 * Estimates of the cost from a node to the goal, micro-cells, and the least cost with the search's moves over an empty
 * map.
 */
export interface Estimates {
  least: number;
  all: Record<"manhattan" | "octile" | "euclid" | "chebyshev", number>;
}

const DIAGONAL = 1_414_214;

/** Null where the moves are not those of four or eight neighbours. */
export function estimatesAt(replay: SearchReplay, node: number, goal: { x: number; y: number }): Estimates | null {
  const { trace } = replay;
  // Any-angle moves and arcs are longer than a step.
  if (trace.kind !== "search" || trace.unit === 1 || samplingOf(replay)) return null;
  const reach = reachOf(trace),
    { width } = trace;
  if (reach === 0) return null;
  const dx = Math.abs((node % width) - goal.x),
    dy = Math.abs(Math.floor(node / width) - goal.y);
  const far = Math.max(dx, dy),
    near = Math.min(dx, dy);
  const all = {
    manhattan: UNIT * (dx + dy),
    octile: UNIT * (far - near) + DIAGONAL * near,
    euclid: UNIT * Math.hypot(dx, dy),
    chebyshev: UNIT * far,
  };
  return { least: reach === 4 ? all.manhattan : all.octile, all };
}

const reaches = new WeakMap<SearchReplay["trace"], 0 | 4 | 8>();

/** How many neighbours a search has, told from its moves; 0 for more than eight. */
function reachOf(trace: SearchTrace): 0 | 4 | 8 {
  let reach = reaches.get(trace);
  if (reach !== undefined) return reach;
  const { width, nodes, targets, first } = trace;
  reach = 4;
  for (let step = 0; step < nodes.length && reach !== 0; step++) {
    const x = nth(nodes, step) % width;
    for (let move = nth(first, step); move < nth(first, step + 1); move++) {
      const column = nth(targets, move) % width;
      const dx = Math.abs(column - x),
        dy = Math.abs((nth(targets, move) - column - nth(nodes, step) + x) / width);
      if (dx > 1 || dy > 1) reach = 0;
      else if (dx + dy === 2 && reach === 4) reach = 8;
    }
  }
  reaches.set(trace, reach);
  return reach;
}

/** A line of pseudocode: its words, its indent, and whether it is the one that the last event stands for. */
export interface CodeLine {
  text: string;
  indent: number;
  current: boolean;
}

const LINE_OF: Record<FateName, Role> = {
  kept: "push",
  improved: "push",
  dearer: "dearer",
  closed: "closed",
  blocked: "blocked",
  corner: "blocked",
  heldBack: "hold",
  requeued: "hold",
  leftOut: "leftOut",
  drawn: "drawn",
};

/** The search as it is written down, with the line of the last event marked. */
export function pseudocode(lang: Lang, replay: SearchReplay, byMoves: boolean): CodeLine[] {
  const sampling = samplingOf(replay),
    now = roleNow(replay, byMoves);
  const lines = sampling ? SAMPLING_CODE[sampling] : linesOf(shapeOf(replay));
  return lines.map(([role, indent, key]) => ({ text: say(lang, key), indent, current: role === now }));
}

interface Shape {
  both: boolean;
  bounds: boolean;
  holds: boolean;
  jumps: boolean;
  leaves: boolean;
  arcs: boolean;
  oldest: boolean;
}

const shapes = new WeakMap<SearchReplay["trace"], Shape>();

/** The kind of search, told from what it did. */
function shapeOf({ trace, sides }: SearchReplay): Shape {
  let shape = shapes.get(trace);
  if (!shape) {
    const has = (fate: number): boolean => trace.fates.some((one) => (one & 15) === fate);
    shape = {
      both: sides.length > 1,
      bounds: trace.kinds.some((kind) => (kind & 15) === STEP.rejected),
      holds: has(FATE.heldBack) || has(FATE.requeued),
      jumps: trace.kind === "search" && !has(FATE.blocked) && !has(FATE.corner) && isJumping(trace),
      leaves: has(FATE.leftOut),
      arcs: trace.kind === "poses",
      oldest: trace.oldestFirst,
    };
    shapes.set(trace, shape);
  }
  return shape;
}

/** True if some move leads farther than any neighbourhood has neighbours. */
function isJumping({ width, nodes, targets, first }: SearchTrace): boolean {
  for (let step = 0; step < nodes.length; step++) {
    const x = nth(nodes, step) % width,
      y = (nth(nodes, step) - x) / width;
    for (let move = nth(first, step); move < nth(first, step + 1); move++) {
      const column = nth(targets, move) % width;
      if (Math.abs(column - x) > 3 || Math.abs((nth(targets, move) - column) / width - y) > 3) return true;
    }
  }
  return false;
}

function linesOf({ both, bounds, holds, jumps, leaves, arcs, oldest }: Shape): [Role, number, Key][] {
  const each: Key = arcs ? "code.eachArc" : jumps ? "code.eachJump" : holds ? "code.eachRisk" : "code.each";
  const lines: ([Role, number, Key] | false)[] = [
    ["init", 0, both ? "code.initBoth" : "code.init"],
    ["while", 0, both ? (arcs ? "code.whileFewer" : "code.whileBoth") : "code.while"],
    ["pop", 1, oldest ? "code.popOldest" : "code.pop"],
    holds && ["deferred", 1, "code.deferred"],
    arcs
      ? ["goal", 1, "code.connect"]
      : bounds
        ? ["bound", 1, "code.bound"]
        : both
          ? ["meet", 1, "code.meet"]
          : ["goal", 1, "code.goal"],
    arcs && both && ["meet", 1, "code.meetPoses"],
    ["close", 1, "code.close"],
    ["each", 1, each],
    !jumps && !arcs && ["blocked", 2, "code.blocked"],
    leaves && ["leftOut", 2, "code.leftOut"],
    ["closed", 2, "code.closed"],
    ["dearer", 2, "code.dearer"],
    arcs && ["blocked", 2, "code.blockedArc"],
    ["push", 2, "code.push"],
    holds && ["hold", 1, "code.hold"],
    ["end", 0, "code.end"],
  ];
  return lines.filter((line) => line !== false);
}

function roleNow(replay: SearchReplay, byMoves: boolean): Role {
  const { step } = replay,
    move = moveShown(replay, byMoves);
  if (step < 0) return "init";
  if (move >= 0) return LINE_OF[replay.fateOf(move)];
  switch (replay.kindOf(step)) {
    case STEP.deferred:
      return "deferred";
    case STEP.rejected:
      return "bound";
    case STEP.goal:
    case STEP.joined:
      return "goal";
    case STEP.meet:
      return "meet";
    default:
      return "pop";
  }
}
