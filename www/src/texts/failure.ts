/** Why a planner's answer fails, in words: what is hit first, where, and what would help. */
import "../i18n/later";
import type { Check, Obstruction, Plan, PlannerId } from "parkade";
import { isMessage, number, translate } from "../i18n/index";
import { translatorAt } from "../i18n/translator";
import { gapAt } from "../scene/gap";
import type { State } from "../store";
import { failureOf, passageOf } from "../view/failure";
import { drivesCar, plannerName, plansRoads } from "../styles/planner-style";
import { statusOf, thingName } from "./status";

const say = translatorAt("failure");

const DEGREES = 180 / Math.PI;

/**
 * The sentences of a planner whose answer cannot be driven; null where it can, or is not there. `brief`: place and
 * remedy only.
 */
export function whyOf(state: State, planner: PlannerId, brief = false): string | null {
  const result = state.results[planner];
  if (result?.status === "error") return result.error?.message ?? null;
  const plan = result?.plan;
  if (!plan || plan.check.drivable) return null;
  const parts = plan.outcome === "found" ? ofPath(state, plan) : ofObstruction(state, plan);
  const remedy = literally(state, plan) ?? helps(state, planner);
  return [...(brief && remedy ? parts.slice(0, 1) : parts), remedy]
    .filter(Boolean)
    .join(state.lang === "zh" ? "" : " ");
}

function ofPath(state: State, plan: Plan): string[] {
  const { lang } = state,
    { check } = plan,
    failure = failureOf(state.scene, plan);
  const metres = (value: number, digits = 2): string => number(lang, value, digits);
  const radii = { radius: metres(check.tightestRadius ?? 0), limit: metres(check.minTurningRadius) },
    along = failure?.along ?? 0;
  if (!check.firstHit) return [turn(state, check, { ...radii, along: metres(along, 1) })];
  const values = { thing: thingName(state, check.firstHit), along: metres(along, 1) };
  const sharp = check.tightestRadius === 0 ? "corners" : isTight(check) ? "curves" : "room";
  return [say(lang, along < 0.05 ? "atStart" : "hit", values), say(lang, sharp, radii)];
}

const isTight = ({ tightestRadius, minTurningRadius }: Check): boolean =>
  (tightestRadius ?? Infinity) < minTurningRadius / 1.001;

function turn({ lang }: State, check: Check, values: Record<string, string>): string {
  if (check.tightestRadius === 0) return say(lang, "spot", values);
  if (isTight(check)) return say(lang, "tight", values);
  const angle = Math.abs(check.startHeadingError) * DEGREES;
  return angle > 5 ? say(lang, "sideways", { angle: number(lang, angle, 0) }) : say(lang, "slides");
}

/** Why the road manuscript's own smoothing or chords fail. */
function literally({ lang, scene }: State, { planner, outcome }: Plan): string | null {
  if (outcome !== "found" || !plansRoads(planner)) return null;
  const { pruning, smoothing } = scene.planners?.[planner] ?? {};
  if (smoothing !== "paper" && pruning !== "los") return null;
  return say(lang, smoothing === "paper" ? "stray" : "sight");
}

/** Another planner in sight that this car can follow; else one that knows cars. */
function helps(state: State, planner: PlannerId): string | null {
  const { lang, planners, results, hidden } = state;
  if (
    ["start-blocked", "goal-blocked", "start-outside", "goal-outside"].includes(results[planner]?.plan?.outcome ?? "")
  )
    return null;
  const good = planners.filter(
    (one) =>
      one !== planner && !hidden.has(one) && results[one]?.status === "done" && statusOf(state, one).tone === "ok",
  );
  const best = good.find((one) => drivesCar(one)) ?? good[0];
  if (best) return say(lang, "drives", { planner: plannerName(lang, best) });
  return drivesCar(planner) || planners.includes("hybrid")
    ? null
    : say(lang, "shape", { planner: plannerName(lang, "hybrid") });
}

function ofObstruction(state: State, plan: Plan): (string | null)[] {
  const { lang } = state,
    { obstruction, outcome, reason } = plan;
  if (obstruction?.kind === "gap") return [say(lang, "gap", gapValues(state, obstruction))];
  if (obstruction?.kind === "contact") {
    return [
      say(lang, "contact", { thing: thingName(state, obstruction.hit), end: say(lang, obstruction.end) }),
      tooSmall(state, plan),
    ];
  }
  const key = `reason.${outcome}`,
    own = isMessage(key) ? translate(lang, key) : null;
  const place =
    !obstruction || (obstruction.kind === "nearest" && outcome === "budget-spent") ? null : say(lang, obstruction.kind);
  const passage = passageOf(state.scene, plan),
    narrow =
      passage &&
      say(lang, "passage", { width: number(lang, passage.width, 2), needed: number(lang, passage.needed, 2) });
  return [searched(state, plan) ?? (lang === "en" && reason ? reason : own), narrow ?? place];
}

/** What hybrid's search has proven or not, and how finely it looked. */
function searched({ lang }: State, plan: Plan): string | null {
  if (plan.detail === "no-room") return say(lang, "no-room");
  if (!("member" in plan) || !plan.member || plan.detail) return null;
  const { xyResolution, headingResolution, margin } = plan.member,
    angle = headingResolution * DEGREES;
  return say(lang, plan.outcome === "no-path" ? "searched" : "undecided", {
    cell: small(lang, xyResolution),
    angle: number(lang, angle, angle % 1 > 0.05 ? 1 : 0),
    margin: small(lang, margin),
    n: number(lang, plan.stats.expanded, 0),
  });
}

/** A length below a metre, in centimetres or millimetres. */
const small = (lang: State["lang"], metres: number): string =>
  metres < 0.01 ? `${number(lang, metres * 1000, 0)} mm` : `${number(lang, metres * 100, 0)} cm`;

/** The gap as it is drawn, where the planner's cells agree with it; shown figures keep their order. */
function gapValues(
  { lang, scene }: State,
  { x, y, width, needed }: Extract<Obstruction, { kind: "gap" }>,
): Record<string, string> {
  const exact = gapAt(scene, [x, y], width, 1.5 * scene.map.resolution)?.width ?? width,
    wide = exact < needed ? exact : width;
  return {
    width: number(lang, wide, 2),
    needed: number(lang, needed, 2),
    more: number(lang, Math.ceil((needed - wide) * 100 - 1e-6) / 100, 2),
  };
}

/** That the car is larger than the slot it shall stand in. */
function tooSmall({ lang, scene, geometry }: State, { obstruction }: Plan): string | null {
  const { goal } = scene,
    slot = "slot" in goal ? scene.slots?.find(({ id }) => id === goal.slot) : undefined;
  const car = geometry?.vehicle;
  if (!slot || !car || obstruction?.kind !== "contact" || obstruction.end !== "goal") return null;
  const length = car.rearToFront + car.rearToBack;
  if (slot.length >= length && slot.width >= car.width) return null;
  const size = (along: number, across: number): string => `${number(lang, along, 2)} × ${number(lang, across, 2)}`;
  return say(lang, "small", { slot: size(slot.length, slot.width), car: size(length, car.width) });
}
