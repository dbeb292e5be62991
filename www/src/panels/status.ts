import type { Check, Plan, PlannerId } from "parkade";
import { isMessage, number, translate, type MessageKey, type Values } from "../i18n/index";
import type { PanelResult, Scene, State } from "../store";
import type { IconName } from "./icons";

export interface Status {
  tone: "ok" | "warn" | "err" | "quiet";
  icon: IconName;
  /** For a panel's chip. */
  chip: string;
  /** For the table. */
  brief: string;
  /** For phones. */
  tiny: string;
  /** What helps, when there is no path. */
  reason: string | null;
}

type Word = { name: string; values?: Values };

const DEGREES = 180 / Math.PI;
const TAIL_IN = 150 / DEGREES;

/** What is to be said of a planner's result, in the words of the page. */
export function statusOf(state: State, planner: PlannerId): Status {
  const result = state.results[planner];
  if (result?.status === "error") {
    return say(state, { name: "error" }, "err", "warning", result.error?.message ?? null);
  }
  if (!result?.plan) return say(state, { name: result?.status === "planning" ? "planning" : "waiting" }, "quiet", "clock");
  return ofPlan(state, result.plan);
}

/** The result's plan when its car can drive it. */
export function drivablePlan(result: PanelResult | undefined): Plan | null {
  return result?.plan?.outcome === "found" && result.plan.check.drivable ? result.plan : null;
}

function ofPlan(state: State, plan: Plan): Status {
  if (plan.outcome !== "found") {
    const key = `reason.${plan.outcome}`;
    const own = isMessage(key) ? translate(state.lang, key) : null;
    const why = [placeOf(state, plan), small(state, plan)], named = ["gap", "contact"].includes(plan.obstruction?.kind ?? "");
    const words = state.lang === "en" && plan.reason ? [plan.reason, ...why.slice(named ? 1 : 0)] : why[0] ? why : [own];
    const reason = words.filter(Boolean).join(" ") || null;
    return say(state, { name: plan.outcome }, "err", "warning", reason);
  }
  const { check } = plan;
  if (check.verdict === "ok") return say(state, { name: "ok" }, "ok", "check");
  if (check.verdict === "arrives-turned") return say(state, turned(state, check), "warn", "turned");
  return say(state, check.verdict === "collides" ? hits(state, check) : tight(state, check), "err", "warning", literally(state, plan));
}

/** Why the road manuscript's own smoothing or chords fail. */
function literally({ lang, scene }: State, { planner }: Plan): string | null {
  const { pruning, smoothing } = scene.planners?.[planner] ?? {};
  if (planner !== "cost-map" || (smoothing !== "paper" && pruning !== "los")) return null;
  return translate(lang, smoothing === "paper" ? "reason.stray" : "reason.los");
}

/** What the mark on the map says. */
function placeOf({ lang }: State, { obstruction, outcome }: Plan): string | null {
  if (!obstruction || (obstruction.kind === "nearest" && outcome === "budget-spent")) return null;
  const values: Values = obstruction.kind === "gap" ? { width: number(lang, obstruction.width, 2), needed: number(lang, obstruction.needed, 2) } : {};
  return translate(lang, `why.${obstruction.kind}`, values);
}

/** That the car is larger than the slot it shall stand in. */
function small({ lang, scene, geometry }: State, { obstruction }: Plan): string | null {
  const { goal } = scene, slot = "slot" in goal ? scene.slots?.find(({ id }) => id === goal.slot) : undefined;
  const car = geometry?.vehicle;
  if (!slot || !car || obstruction?.kind !== "contact" || obstruction.end !== "goal") return null;
  const length = car.rearToFront + car.rearToBack;
  if (slot.length >= length && slot.width >= car.width) return null;
  const size = (along: number, across: number): string => `${number(lang, along, 2)} × ${number(lang, across, 2)}`;
  return translate(lang, "why.small", { slot: size(slot.length, slot.width), car: size(length, car.width) });
}

function turned({ lang }: State, check: Check): Word {
  const error = Math.abs(check.goalHeadingError);
  if (error >= TAIL_IN) return { name: "tail-in" };
  return { name: "turned", values: { angle: number(lang, error * DEGREES, 0) } };
}

function hits(state: State, check: Check): Word {
  return { name: "hits", values: { n: check.hits, thing: thingOf(state, check) } };
}

function tight({ lang }: State, check: Check): Word {
  if (check.tightestRadius === 0) return { name: "spot" };
  if ((check.tightestRadius ?? Infinity) >= check.minTurningRadius) {
    return { name: "sideways", values: { angle: number(lang, Math.abs(check.startHeadingError) * DEGREES, 0) } };
  }
  return {
    name: "tight",
    values: { radius: number(lang, check.tightestRadius ?? 0, 2), limit: number(lang, check.minTurningRadius, 2) },
  };
}

function thingOf({ lang, scene }: State, { firstHit }: Check): string {
  if (!firstHit) return translate(lang, "thing.other");
  const kind = obstacleKind(scene, firstHit.index, firstHit.obstacle);
  const key = `thing.${kind}`;
  return translate(lang, isMessage(key) ? key : "thing.other");
}

function obstacleKind(scene: Scene, index: number, name: string): string {
  const obstacle = scene.obstacles?.[index] ?? scene.obstacles?.find((one) => one.id === name);
  if (obstacle) return obstacle.type;
  return (scene.slots ?? []).some((slot) => slot.id === name) ? "slot" : name.replace(/[^a-z].*$/, "");
}

function tinyOf({ lang }: State, name: string, values?: Values): string | null {
  const key = `tiny.${name}`;
  return isMessage(key) ? translate(lang, key, values) : null;
}

function say(state: State, { name, values }: Word, tone: Status["tone"], icon: IconName, reason: string | null = null): Status {
  const word = (prefix: string): string => translate(state.lang, `${prefix}.${name}` as MessageKey, values);
  return { tone, icon, chip: word("status"), brief: word("brief"), tiny: tinyOf(state, name, values) ?? word("brief"), reason };
}
