/**
 * What values from outside must be: of a link's view, of messages and properties, of what the browser keeps. One table,
 * bounds included.
 */
import type { ParameterInfo, PlannerInfo } from "parkade";
import type { Lang, Values } from "../i18n/index";
import messages from "../i18n/messages/rules.json";
import { translator } from "../i18n/translator";
import type { Scenario } from "../scene/scenario";
import { ALL_LAYERS, LAYER_PRESETS } from "../store/layer-sets";
import { cameraLimits } from "../view/camera";
import { fieldsOf } from "../scene/records";

const say = translator("rule", messages);

/** A rule's name, with the figures and names that it depends on. */
interface Stated {
  rule: Exclude<Parameters<typeof say>[1], "fault">;
  least?: number;
  most?: number;
  names?: readonly unknown[];
  why?: string;
}
interface Fault extends Stated {
  field: string;
  value: unknown;
}
/** The first fault of a value, or null. */
export type Rule = (value: unknown, field: string) => Fault | null;

/** Names the field, the value and the rule; nothing has changed when it is thrown. */
export class ValueError extends RangeError {
  override readonly name = "ValueError";
  readonly field: string;
  readonly value: unknown;
  readonly rule: string;
  readonly sentence: (lang: Lang) => string;

  constructor(fault: Fault) {
    super(sentenceOf("en", fault));
    this.field = fault.field;
    this.value = fault.value;
    this.rule = ruleOf("en", fault);
    this.sentence = (lang) => sentenceOf(lang, fault);
  }
}

function ruleOf(lang: Lang, { rule, least = 0, most = 0, names = [], why = "" }: Stated): string {
  const values: Values = { least, most, why, names: names.join(lang === "zh" ? "、" : ", ") };
  return say(lang, rule, values);
}

const sentenceOf = (lang: Lang, fault: Fault): string =>
  say(lang, "fault", { field: fault.field, rule: ruleOf(lang, fault), value: shown(fault.value) });

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
  (holds: (value: unknown) => boolean, stated: Stated): Rule =>
  (value, field) =>
    holds(value) ? null : { field, value, ...stated };

export const oneOf = (names: readonly unknown[]): Rule =>
  rule((value) => names.includes(value), { rule: "oneOf", names });

export const numberFrom = (least: number, most: number): Rule =>
  rule((value) => typeof value === "number" && value >= least && value <= most, { rule: "number", least, most });

const wholeFrom = (least: number, most: number): Rule =>
  rule((value) => Number.isInteger(value) && Number(value) >= least && Number(value) <= most, {
    rule: "whole",
    least,
    most,
  });

export const textUpTo = (most: number): Rule =>
  rule((value) => typeof value === "string" && value.length <= most, { rule: "text", most });

const boolean = rule((value) => typeof value === "boolean", { rule: "boolean" });
const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const orNull =
  (inner: Rule): Rule =>
  (value, field) =>
    value === null ? null : inner(value, field);

/** A list of different values. */
const listOf = (each: Rule, least: number, most: number): Rule => {
  const size = rule((value) => Array.isArray(value) && value.length >= least && value.length <= most, {
    rule: "list",
    least,
    most,
  });
  const listed = (value: unknown): unknown[] => (Array.isArray(value) ? value : []);
  const distinct = rule((value) => new Set(listed(value)).size === listed(value).length, { rule: "distinct" });
  return (value, field) =>
    size(value, field) ??
    firstFault(listed(value).map((one, i) => each(one, `${field}[${i}]`))) ??
    distinct(value, field);
};

/** An object of these fields and no others. */
export const objectOf = (fields: Record<string, Rule>, optional: readonly string[] = []): Rule => {
  const isObject = rule(isRecord, { rule: "object", names: Object.keys(fields) });
  const known = oneOf(Object.keys(fields));
  return (value, field) =>
    isObject(value, field) ??
    firstFault(Object.keys(fieldsOf(value)).map((key) => known(key, `${field}.${key}`))) ??
    firstFault(
      Object.entries(fields).map(([key, one]) => {
        const inner = fieldsOf(value)[key];
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
  smooth: (text) => [text, oneOf(["true", "false"])],
  loading: (text) => [text, oneOf(["auto", "lazy", "eager"])],
  reveal: (text) => [text, oneOf(["auto", "interaction", "manual"])],
  editable: (text) => [text || "true", oneOf(["true", "false"])],
  speed: (text) => [figure(text), numberFrom(0.01, 100)],
  "budget-ms": (text) => [figure(text), numberFrom(1, HOUR_MS)],
  layers: (text) => [
    text.split(/\s+/).filter(Boolean),
    listOf(oneOf([...new Set([...LAYER_PRESETS, ...ALL_LAYERS])]), 0, ALL_LAYERS.length),
  ],
};

export function faultOfAttribute(name: string, text: string): ValueError | null {
  const [value, rule] = ATTRIBUTES[name]?.(text) ?? [];
  const fault = rule?.(value, name);
  return fault ? new ValueError(fault) : null;
}

/** An empty text is no zero. */
export const numeral = (text: string | undefined): number => (text ? Number(text) : NaN);

/** The number, or else the text that is none. */
const figure = (text: string): unknown => (Number.isNaN(numeral(text)) ? text : numeral(text));

/**
 * What the browser keeps of a setting, by its key's beginning; other keys are somebody else's, or look after
 * themselves.
 */
const STORED: Record<string, (text: string) => [value: unknown, rule: Rule]> = {
  "parkade.theme": (text) => [text, RULES.theme()],
  "parkade.lang": (text) => [text, RULES.lang()],
  "parkade.smooth": (text) => [text, oneOf(["on", "off"])],
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
