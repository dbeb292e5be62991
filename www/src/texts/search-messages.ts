import type { Pose } from "parkade";
import { number, type Lang } from "../i18n/index";
import messages from "../i18n/messages/debugger.json";
import { translator } from "../i18n/translator";
import type { SearchReplay } from "../planning/search-replay";
import { nth } from "../scene/nth";

export const say = translator("debugger", messages);
export type Key = Parameters<typeof say>[1];

const DEGREES = 180 / Math.PI;

/** Costs as people read them: cells or metres. */
export const cost = (lang: Lang, { trace }: SearchReplay, value: number): string => number(lang, value / trace.unit, 2);

/** Column and row of a node of a side, or its pose. */
export function placeOf(lang: Lang, replay: SearchReplay, side: number, node: number): string {
  const { trace } = replay;
  return trace.kind === "search"
    ? `(${node % trace.width}, ${Math.floor(node / trace.width)})`
    : poseText(lang, replay.poseOf(side, node)!);
}

/** The place of the node that a step took. */
export const placeOfStep = (lang: Lang, replay: SearchReplay, step: number): string =>
  placeOf(lang, replay, replay.sideOf(step), nth(replay.trace.nodes, step));

/** Column and row of a move's target, or the pose that it leads to. */
export function targetOf(lang: Lang, replay: SearchReplay, move: number): string {
  const pose = replay.poseAfter(move);
  return pose ? poseText(lang, pose) : placeOf(lang, replay, 0, nth(replay.trace.targets, move));
}

function poseText(lang: Lang, { x, y, heading }: Pose): string {
  const degrees = (((heading * DEGREES) % 360) + 360) % 360;
  return `(${number(lang, x, 2)}, ${number(lang, y, 2)}, ${number(lang, degrees, 0)}°)`;
}

/** What a line of pseudocode stands for. */
export type Role =
  | "init"
  | "while"
  | "pop"
  | "goal"
  | "meet"
  | "bound"
  | "close"
  | "each"
  | "end"
  | "deferred"
  | "blocked"
  | "leftOut"
  | "closed"
  | "dearer"
  | "push"
  | "hold"
  | "drawn";
