/** What values from outside must be: of a link's view, of messages and properties, of what the browser keeps. One table, bounds included. */
import type { ParameterInfo, PlannerInfo } from "parkade";
import type { Scenario } from "../scene/scenario";
import { ALL_LAYERS, LAYER_PRESETS } from "../store/layer-sets";
import { cameraLimits } from "../view/camera";

type Words = readonly [en: string, zh: string];
interface Fault {
  field: string;
  value: unknown;
  words: Words;
}
/** The first fault of a value, or null. */
export type Rule = (value: unknown, field: string) => Fault | null;

/** Names the field, the value and the rule; nothing has changed when it is thrown. */
export class ValueError extends RangeError {
  override readonly name = "ValueError";
  readonly field: string;
  readonly value: unknown;
  readonly rule: string;
  private readonly words: Words;

  constructor({ field, value, words }: Fault) {
    super(`${field}: ${words[0]}, got ${shown(value)}`);
    this.field = field;
    this.value = value;
    this.rule = words[0];
    this.words = words;
  }

  sentence(lang: "en" | "zh"): string {
    return lang === "zh" ? `${this.field}：${this.words[1]}，实际为 ${shown(this.value)}` : this.message;
  }
}

/** Throws a `ValueError` where the rule is broken. */
export function check<T>(value: unknown, rule: Rule, field: string): T {
  const fault = rule(value, field);
  if (fault) throw new ValueError(fault);
  return value as T;
}

const LONGEST_SHOWN = 40;

function shown(value: unknown): string {
  let text: string | undefined;
  try {
    text =
      typeof value !== "number"
        ? JSON.stringify(value)
        : Math.abs(value) < 1e7
          ? String(value)
          : value.toExponential().replace("+", "");
  } catch {
    // Cycles and big integers have no JSON.
  }
  text ??= typeof value;
  return text.length > LONGEST_SHOWN ? `${text.slice(0, LONGEST_SHOWN)}…` : text;
}

const rule =
  (holds: (value: unknown) => boolean, en: string, zh: string): Rule =>
  (value, field) =>
    holds(value) ? null : { field, value, words: [en, zh] };

export const oneOf = (names: readonly unknown[]): Rule =>
  rule((value) => names.includes(value), `must be one of ${names.join(", ")}`, `必须是 ${names.join("、")} 之一`);

export const numberFrom = (least: number, most: number): Rule =>
  rule(
    (value) => typeof value === "number" && value >= least && value <= most,
    `must be a number from ${least} to ${most}`,
    `必须是 ${least} 到 ${most} 之间的数`,
  );

const wholeFrom = (least: number, most: number): Rule =>
  rule(
    (value) => Number.isInteger(value) && Number(value) >= least && Number(value) <= most,
    `must be a whole number from ${least} to ${most}`,
    `必须是 ${least} 到 ${most} 之间的整数`,
  );

export const textUpTo = (most: number): Rule =>
  rule(
    (value) => typeof value === "string" && value.length <= most,
    `must be a text of at most ${most} characters`,
    `必须是不超过 ${most} 个字符的文本`,
  );

const boolean = rule((value) => typeof value === "boolean", "must be true or false", "必须是 true 或 false");
const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const orNull =
  (inner: Rule): Rule =>
  (value, field) =>
    value === null ? null : inner(value, field);

/** A list of different values. */
const listOf = (each: Rule, least: number, most: number): Rule => {
  const size = rule(
    (value) => Array.isArray(value) && value.length >= least && value.length <= most,
    `must be a list of ${least} to ${most}`,
    `必须是 ${least} 到 ${most} 项的列表`,
  );
  const distinct = rule(
    (value) => new Set(value as unknown[]).size === (value as unknown[]).length,
    "must be a list of different values",
    "必须是互不相同的列表",
  );
  return (value, field) =>
    size(value, field) ??
    firstFault((value as unknown[]).map((one, i) => each(one, `${field}[${i}]`))) ??
    distinct(value, field);
};

/** An object of these fields and no others. */
export const objectOf = (fields: Record<string, Rule>, optional: readonly string[] = []): Rule => {
  const isObject = rule(
    isRecord,
    `must be an object of ${Object.keys(fields).join(", ")}`,
    `必须是包含 ${Object.keys(fields).join("、")} 的对象`,
  );
  const known = oneOf(Object.keys(fields));
  return (value, field) =>
    isObject(value, field) ??
    firstFault(Object.keys(value as object).map((key) => known(key, field))) ??
    firstFault(
      Object.entries(fields).map(([key, one]) => {
        const inner = (value as Record<string, unknown>)[key];
        return inner === undefined && optional.includes(key) ? null : one(inner, `${field}.${key}`);
      }),
    );
};

const firstFault = (faults: readonly (Fault | null)[]): Fault | null => faults.find((fault) => fault !== null) ?? null;

export const MODES = ["grid", "overlay", "focus"] as const;
const BASES = ["drive", "search"] as const;
export const PREFERENCES = ["shortest", "fewest-changes", "widest", "fastest"] as const;
export const SEARCH_MODES = ["percent", "expansions"] as const;
const HOUR_MS = 3_600_000;
/** Characters; a scene of millions of cells makes no link. */
const LONGEST_LINK = 1_000_000;

/** Facts that the rules depend on. */
export interface Known {
  planners: readonly PlannerInfo[];
  map: Scenario["map"];
}

/** Every field that comes from outside, whichever way it comes. */
export const RULES = {
  mode: () => oneOf(MODES),
  planners: ({ planners }: Known) => listOf(oneOf(planners.map(({ id }) => id)), 1, planners.length),
  focus: (shownPlanners: readonly string[]) => oneOf(shownPlanners),
  layerBits: (count: number) => wholeFrom(0, 2 ** count - 1),
  base: () => oneOf(BASES),
  searchMode: () => oneOf(SEARCH_MODES),
  prefer: () => oneOf(PREFERENCES),
  playhead: () => numberFrom(0, 1),
  seekOptions: () => objectOf({ base: oneOf(BASES) }, ["base"]),
  blobOptions: () => objectOf({ type: oneOf(["image/png", "image/jpeg", "image/webp"]) }, ["type"]),
  link: () => textUpTo(LONGEST_LINK),
  theme: () => oneOf(["auto", "light", "dark"]),
  lang: () => oneOf(["en", "zh"]),
  camera: ({ map }: Known) => {
    const { x, y, scale } = cameraLimits(map);
    return orNull(objectOf({ x: numberFrom(...x), y: numberFrom(...y), scale: numberFrom(...scale) }));
  },
  params: ({ planners }: Known) =>
    objectOf(
      Object.fromEntries(planners.map(({ id, parameters }) => [id, settings(parameters)])),
      planners.map(({ id }) => id),
    ),
} as const;

/** Rules for the texts of attributes; other attributes accept anything. */
const ATTRIBUTES: Record<string, (text: string) => [value: unknown, rule: Rule]> = {
  layout: (text) => [text, oneOf([...MODES, "single"])],
  controls: (text) => [text, oneOf(["full", "minimal", "none"])],
  wheel: (text) => [text, oneOf(["ctrl", "always", "none"])],
  theme: (text) => [text, RULES.theme()],
  speed: (text) => [numeral(text), numberFrom(0.01, 100)],
  "budget-ms": (text) => [numeral(text), numberFrom(1, HOUR_MS)],
  layers: (text) => [
    text.split(/\s+/).filter(Boolean),
    listOf(oneOf([...LAYER_PRESETS, ...ALL_LAYERS]), 0, ALL_LAYERS.length),
  ],
};

export function faultOfAttribute(name: string, text: string): ValueError | null {
  const [value, rule] = ATTRIBUTES[name]?.(text) ?? [];
  const fault = rule?.(value, name);
  return fault ? new ValueError(fault) : null;
}

/** An empty text is no zero. */
export const numeral = (text: string | undefined): number => (text ? Number(text) : NaN);

/** What the browser keeps of a setting, by its key's beginning; other keys are somebody else's, or look after themselves. */
const STORED: Record<string, (text: string) => [value: unknown, rule: Rule]> = {
  "parkade.theme": (text) => [text, RULES.theme()],
  "parkade.lang": (text) => [text, RULES.lang()],
  "parkade.pane.": (text) => [numeral(text), numberFrom(100, 1000)],
  "parkade.hint.": (text) => [text, oneOf(["seen"])],
};

export function keepsRule(key: string, text: string): boolean {
  const start = Object.keys(STORED).find((one) => key.startsWith(one));
  if (!start) return true;
  const [value, rule] = STORED[start]!(text);
  return rule(value, key) === null;
}

/** A planner's own settings. */
const settings = (parameters: readonly ParameterInfo[]): Rule =>
  objectOf(
    Object.fromEntries(parameters.map((info) => [info.name, setting(info)])),
    parameters.map(({ name }) => name),
  );

function setting({ type, min = -Infinity, max = Infinity, choices = [], default: usual }: ParameterInfo): Rule {
  const one =
    type === "boolean"
      ? boolean
      : type === "choice"
        ? oneOf(choices)
        : (type === "integer" ? wholeFrom : numberFrom)(min, max);
  return usual === null ? orNull(one) : one;
}
