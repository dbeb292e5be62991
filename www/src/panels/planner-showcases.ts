/** Built-in scenes on which each planner shines, and on which it struggles. */
import type { PlannerId, ScenarioInfo } from "parkade";
import { number, type Lang } from "../i18n/index";
import messages from "../i18n/messages/planner-showcases.json";
import { translator } from "../i18n/translator";

interface Case {
  scene: string;
  question: Question;
}
export interface Cases {
  best: Case;
  worst: Case;
}

const say = translator("showcase", messages);
type Question = Parameters<typeof say>[1];

const one = (scene: string, question: Question): Case => ({ scene, question });

export const questionOf = (lang: Lang, { question }: Case): string => say(lang, question);

/**
 * A best case hits nothing, or its question says that the car may not fit; tests/js/cases.test.ts holds what is
 * asserted.
 */
export const CASES: readonly (readonly [PlannerId, Cases])[] = [
  [
    "four",
    {
      best: one("road-straight", "four.best"),
      worst: one("parallel", "four.worst"),
    },
  ],
  [
    "eight",
    {
      best: one("road-straight", "eight.best"),
      worst: one("P0", "eight.worst"),
    },
  ],
  [
    "sixteen",
    {
      best: one("L4", "sixteen.best"),
      worst: one("reverse-in", "sixteen.worst"),
    },
  ],
  [
    "twenty-four",
    {
      best: one("L4", "twenty-four.best"),
      worst: one("regular-60", "twenty-four.worst"),
    },
  ],
  [
    "forty-eight",
    {
      best: one("L4", "forty-eight.best"),
      worst: one("regular-60", "forty-eight.worst"),
    },
  ],
  [
    "sixteen-bidirectional",
    {
      best: one("reverse-in", "sixteen-bidirectional.best"),
      worst: one("trap-60", "sixteen-bidirectional.worst"),
    },
  ],
  [
    "jump-point",
    {
      best: one("L4", "jump-point.best"),
      worst: one("regular-60", "jump-point.worst"),
    },
  ],
  [
    "any-angle",
    {
      best: one("P3", "any-angle.best"),
      worst: one("trap-60", "any-angle.worst"),
    },
  ],
  [
    "risk-field",
    {
      best: one("P4", "risk-field.best"),
      worst: one("narrow-gap", "risk-field.worst"),
    },
  ],
  [
    "risk-field-plus",
    {
      best: one("P4", "risk-field-plus.best"),
      worst: one("trap-60", "risk-field-plus.worst"),
    },
  ],
  [
    "hybrid",
    {
      best: one("angled", "hybrid.best"),
      worst: one("par-7.2", "hybrid.worst"),
    },
  ],
  [
    "hybrid-forward",
    {
      best: one("L3", "hybrid-forward.best"),
      worst: one("perp-nose-3.2", "hybrid-forward.worst"),
    },
  ],
  [
    "hybrid-bidirectional",
    {
      best: one("perp-nose-3.2", "hybrid-bidirectional.best"),
      worst: one("par-7.2", "hybrid-bidirectional.worst"),
    },
  ],
  [
    "hybrid-classic",
    {
      best: one("L3", "hybrid-classic.best"),
      worst: one("regular-60", "hybrid-classic.worst"),
    },
  ],
  [
    "cost-map",
    {
      best: one("road-crossing", "cost-map.best"),
      worst: one("reverse-in", "cost-map.worst"),
    },
  ],
  [
    "dijkstra",
    {
      best: one("road-straight", "dijkstra.best"),
      worst: one("random-60", "dijkstra.worst"),
    },
  ],
  [
    "greedy",
    {
      best: one("road-straight", "greedy.best"),
      worst: one("trap-60", "greedy.worst"),
    },
  ],
  [
    "rrt",
    {
      best: one("perpendicular", "rrt.best"),
      worst: one("road-curve", "rrt.worst"),
    },
  ],
  [
    "genetic",
    {
      best: one("P4", "genetic.best"),
      worst: one("fig9-100", "genetic.worst"),
    },
  ],
];

/** Of each row of the parking paper, as printed: traditional length and gear changes, then improved; metres. */
export const PRINTED: Readonly<Record<string, readonly [number, number, number, number]>> = {
  P0: [24.1, 2, 22.7, 1],
  P1: [26.2, 2, 24.6, 1],
  P2: [21.2, 2, 19.1, 1],
  P3: [25.5, 2, 23.2, 0],
  P4: [28.4, 2, 27.3, 1],
  L0: [46, 3, 41.8, 1],
  L1: [37.9, 4, 28.3, 2],
  L2: [29.4, 3, 26.1, 1],
  L3: [26.7, 3, 20.2, 1],
  L4: [31.3, 4, 25, 1],
};

/** Rows of the paper whose start touches the boundary. */
const AGAINST: readonly string[] = ["P1"];

/** Caption of a gallery card. */
export function captionOf({ id, question }: Pick<ScenarioInfo, "id" | "question">, lang: Lang): string {
  const [a, m, b, n] = PRINTED[id] ?? [];
  if (a === undefined || b === undefined) return question[lang];
  const row = say(lang, "printed", { a: number(lang, a, 1), m: m!, b: number(lang, b, 1), n: n! });
  return AGAINST.includes(id) ? `${row} ${say(lang, "against")}` : row;
}
