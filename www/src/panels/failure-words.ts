/** Why a planner's answer fails, in words: what is hit first, where, and what would help. */
import "../i18n/later";
import type { Check, Obstruction, Plan, PlannerId } from "parkade";
import { isMessage, number, translate } from "../i18n/index";
import { words } from "../i18n/words";
import { gapAt } from "../scene/gap";
import type { State } from "../store";
import { failureOf } from "../view/failure";
import { identityOf, plannerName } from "../view/identity";
import { statusOf, thingName } from "./status";

const say = words({
  hit: ["Hits {thing} after {along} m.", "行驶 {along} m 后撞上{thing}。"],
  atStart: ["Overlaps {thing} at the start.", "在起点处与{thing}重叠。"],
  corners: ["Its path has corners that this car cannot follow.", "路径带有折角，此车无法跟随。"],
  curves: ["Its path turns in {radius} m; this car needs {limit} m.", "路径转弯半径 {radius} m，此车需要 {limit} m。"],
  room: ["Its path passes too close to obstacles for this car.", "路径离障碍物过近，容不下此车。"],
  spot: ["Turns in place after {along} m: this car needs a radius of {limit} m.", "行驶 {along} m 后原地转向：此车至少需要 {limit} m 半径。"],
  tight: ["Turns in {radius} m after {along} m: this car needs {limit} m.", "行驶 {along} m 后转弯半径仅 {radius} m：此车需要 {limit} m。"],
  sideways: ["Starts {angle}° off the car’s heading.", "起步方向与车头相差 {angle}°。"],
  slides: ["Its path moves the car sideways.", "路径要求车辆侧移。"],
  drives: ["{planner} finds a path.", "{planner}可行。"],
  shape: ["{planner} plans for the car’s shape.", "{planner}按车身形状规划。"],
  contact: ["The car overlaps {thing} at the {end}. Move one of them.", "车辆在{end}与{thing}重叠，请移动其中之一。"],
  start: ["start", "起点"],
  goal: ["goal", "目标"],
  gap: ["No way through: the gap is {width} m wide, the car needs {needed} m. Widen it by {more} m or more.", "无法通过：间隙宽 {width} m，车身需要 {needed} m，至少再加宽 {more} m。"],
  enclosed: ["The hatched area has no way out. Open one.", "阴影区域没有出口，请打通一处。"],
  "boxed-in": ["The car can barely move: it is blocked at the hatched poses. Give it more room there.", "车辆几乎无法移动：在阴影位姿处受阻，请在那里留出更多空间。"],
  nearest: ["The ring marks the searched pose closest to the goal.", "圆圈标出搜索到的最接近目标的位姿。"],
  small: ["The slot is {slot} m, the car {car} m.", "车位 {slot} m，车身 {car} m。"],
  stray: ["The paper’s curve may leave its control points by a metre, more than the room beside the car.", "论文曲线可偏离控制点一米，超过车道内车旁的空隙。"],
  sight: ["The paper’s chords only need line of sight, so they pass corners without room for the car.", "论文的折线只要求视线可达，经过拐角时容不下车身。"],
});

const DEGREES = 180 / Math.PI;

/** The sentences of a planner whose answer cannot be driven; null where it can, or is not there. `brief`: place and remedy only. */
export function whyOf(state: State, planner: PlannerId, brief = false): string | null {
  const result = state.results[planner];
  if (result?.status === "error") return result.error?.message ?? null;
  const plan = result?.plan;
  if (!plan || plan.check.drivable) return null;
  const parts = plan.outcome === "found" ? ofPath(state, plan) : ofObstruction(state, plan);
  const remedy = literally(state, plan) ?? helps(state, planner);
  return [...(brief && remedy ? parts.slice(0, 1) : parts), remedy].filter(Boolean).join(state.lang === "zh" ? "" : " ");
}

function ofPath(state: State, plan: Plan): string[] {
  const { lang } = state, { check } = plan, failure = failureOf(state.scene, plan);
  const metres = (value: number, digits = 2): string => number(lang, value, digits);
  const radii = { radius: metres(check.tightestRadius ?? 0), limit: metres(check.minTurningRadius) }, along = failure?.along ?? 0;
  if (!check.firstHit) return [turn(state, check, { ...radii, along: metres(along, 1) })];
  const values = { thing: thingName(state, check.firstHit), along: metres(along, 1) };
  const sharp = check.tightestRadius === 0 ? "corners" : isTight(check) ? "curves" : "room";
  return [say(lang, along < 0.05 ? "atStart" : "hit", values), say(lang, sharp, radii)];
}

const isTight = ({ tightestRadius, minTurningRadius }: Check): boolean => (tightestRadius ?? Infinity) < minTurningRadius / 1.001;

function turn({ lang }: State, check: Check, values: Record<string, string>): string {
  if (check.tightestRadius === 0) return say(lang, "spot", values);
  if (isTight(check)) return say(lang, "tight", values);
  const angle = Math.abs(check.startHeadingError) * DEGREES;
  return angle > 5 ? say(lang, "sideways", { angle: number(lang, angle, 0) }) : say(lang, "slides");
}

/** Why the road manuscript's own smoothing or chords fail. */
function literally({ lang, scene }: State, { planner, outcome }: Plan): string | null {
  const { pruning, smoothing } = scene.planners?.[planner] ?? {};
  if (outcome !== "found" || planner !== "cost-map" || (smoothing !== "paper" && pruning !== "los")) return null;
  return say(lang, smoothing === "paper" ? "stray" : "sight");
}

/** Another planner in sight that this car can follow; else one that knows cars. */
function helps(state: State, planner: PlannerId): string | null {
  const { lang, planners, results, hidden } = state;
  if (["start-blocked", "goal-blocked", "start-outside", "goal-outside"].includes(results[planner]?.plan?.outcome ?? "")) return null;
  const good = planners.filter((one) => one !== planner && !hidden.has(one) && results[one]?.status === "done" && statusOf(state, one).tone === "ok");
  const best = good.find((one) => identityOf(one).drives) ?? good[0];
  if (best) return say(lang, "drives", { planner: plannerName(lang, best) });
  return identityOf(planner).drives || planners.includes("hybrid") ? null : say(lang, "shape", { planner: plannerName(lang, "hybrid") });
}

function ofObstruction(state: State, plan: Plan): (string | null)[] {
  const { lang } = state, { obstruction, outcome, reason } = plan;
  if (obstruction?.kind === "gap") return [say(lang, "gap", gapValues(state, obstruction))];
  if (obstruction?.kind === "contact") {
    return [say(lang, "contact", { thing: thingName(state, obstruction.hit), end: say(lang, obstruction.end) }), small(state, plan)];
  }
  const key = `reason.${outcome}`, own = isMessage(key) ? translate(lang, key) : null;
  const place = !obstruction || (obstruction.kind === "nearest" && outcome === "budget-spent") ? null : say(lang, obstruction.kind);
  return [lang === "en" && reason ? reason : own, place];
}

/** The gap as it is drawn, where the planner's cells agree with it; shown figures keep their order. */
function gapValues({ lang, scene }: State, { x, y, width, needed }: Extract<Obstruction, { kind: "gap" }>): Record<string, string> {
  const exact = gapAt(scene, [x, y], width, 1.5 * scene.map.resolution)?.width ?? width, wide = exact < needed ? exact : width;
  return { width: number(lang, wide, 2), needed: number(lang, needed, 2), more: number(lang, Math.ceil((needed - wide) * 100 - 1e-6) / 100, 2) };
}

/** That the car is larger than the slot it shall stand in. */
function small({ lang, scene, geometry }: State, { obstruction }: Plan): string | null {
  const { goal } = scene, slot = "slot" in goal ? scene.slots?.find(({ id }) => id === goal.slot) : undefined;
  const car = geometry?.vehicle;
  if (!slot || !car || obstruction?.kind !== "contact" || obstruction.end !== "goal") return null;
  const length = car.rearToFront + car.rearToBack;
  if (slot.length >= length && slot.width >= car.width) return null;
  const size = (along: number, across: number): string => `${number(lang, along, 2)} × ${number(lang, across, 2)}`;
  return say(lang, "small", { slot: size(slot.length, slot.width), car: size(length, car.width) });
}
