import type { Check, Hit, Plan, PlannerId } from "parkade";
import { isMessage, millis, number, translate, type Lang, type MessageKey, type Values } from "../i18n/index";
import type { PanelResult, State } from "../store";
import type { IconName } from "../styles/icons";

export interface Status {
  tone: "ok" | "warn" | "err" | "quiet";
  icon: IconName;
  /** For a panel's chip. */
  chip: string;
  /** On hover; the chip's text where nothing more is to be said. */
  title?: string;
  /** For the table. */
  brief: string;
  /** For phones. */
  tiny: string;
}

type Word = { name: string; values?: Values };

const DEGREES = 180 / Math.PI;
const TAIL_IN = 150 / DEGREES;
/** Names that the page gives. */
const MADE = /^[a-z]+-\d+$/;
const NOTHING = { index: -1, obstacle: "" };

/** The status of a planner's result in the page's words. */
export function statusOf(state: State, planner: PlannerId): Status {
  const result = state.results[planner];
  if (result?.status === "error") {
    return statusFrom(state, { name: "error" }, "err", "warning");
  }
  if (!result?.plan)
    return statusFrom(state, { name: result?.status === "planning" ? "planning" : "waiting" }, "quiet", "clock");
  return ofPlan(state, result.plan);
}

/** How long the search took; an ellipsis until that is known of compiled code. */
export function searchTime(lang: Lang, result: PanelResult | undefined): string {
  return result?.time ? `${millis(lang, result.time.search)} ms` : result?.plan ? "…" : "";
}

/** … and with all that follows it. */
export function timeTitle(lang: Lang, result: PanelResult | undefined): string {
  return result?.time
    ? translate(lang, "panel.time", {
        search: millis(lang, result.time.search),
        total: millis(lang, result.time.total),
      })
    : "";
}

/** The result's plan when its car can drive it. */
export function drivablePlan(result: PanelResult | undefined): Plan | null {
  return result?.plan?.outcome === "found" && result.plan.check.drivable ? result.plan : null;
}

function ofPlan(state: State, plan: Plan): Status {
  if (plan.outcome !== "found") return statusFrom(state, { name: plan.outcome }, "err", "warning");
  const { check } = plan;
  if (check.verdict === "ok") return statusFrom(state, { name: "ok" }, "ok", "check");
  if (check.verdict === "arrives-turned") return statusFrom(state, turned(state, check), "warn", "turned");
  return statusFrom(state, check.verdict === "collides" ? hits(state, check) : tight(state, check), "err", "warning");
}

function turned({ lang }: State, check: Check): Word {
  const error = Math.abs(check.goalHeadingError);
  if (error >= TAIL_IN) return { name: "tail-in" };
  return { name: "turned", values: { angle: number(lang, error * DEGREES, 0) } };
}

function hits(state: State, check: Check): Word {
  return { name: "hits", values: { n: check.hits, thing: thingName(state, check.firstHit ?? NOTHING) } };
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

/** By the name that a person gave it, else by its kind, counted where there are several. */
export function thingName(
  { lang, scene: { obstacles = [], slots = [] } }: State,
  { index, obstacle: id }: Pick<Hit, "index" | "obstacle">,
): string {
  const obstacle = obstacles[index],
    slot = slots.findIndex((one) => one.id === id);
  if (obstacle?.id && !(obstacle.id.startsWith(`${obstacle.type}-`) && MADE.test(obstacle.id))) {
    const [, own, n] = /^(.*?)(?:-(\d+))?$/.exec(obstacle.id)!,
      key = `thing.${own}`;
    return !isMessage(key) ? `“${id}”` : n ? counted(translate(lang, key), n) : translate(lang, key);
  }
  if (!obstacle)
    return translate(lang, slot >= 0 ? "thing.slot" : id === "border" ? "thing.border" : "thing.other", {
      n: slot + 1,
    });
  const alike = obstacles.filter(({ type }) => type === obstacle.type),
    kind = translate(lang, `thing.${obstacle.type}`);
  return alike.length > 1 ? counted(kind, alike.indexOf(obstacle) + 1) : kind;
}

const counted = (kind: string, n: number | string): string => `${kind.replace(/^the /, "")} ${n}`;

function tinyOf({ lang }: State, name: string, values?: Values): string | null {
  const key = `tiny.${name}`;
  return isMessage(key) ? translate(lang, key, values) : null;
}

function statusFrom(state: State, { name, values }: Word, tone: Status["tone"], icon: IconName): Status {
  const word = (prefix: string): string => translate(state.lang, `${prefix}.${name}` as MessageKey, values);
  return { tone, icon, chip: word("status"), brief: word("brief"), tiny: tinyOf(state, name, values) ?? word("brief") };
}
