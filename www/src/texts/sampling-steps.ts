import type { Lang } from "../i18n/index";
import { FATE, STEP, type FateName, type SearchReplay } from "../planning/search-replay";
import { cost, placeOf, placeOfStep, say, type Key, type Role } from "./search-messages";
import { nth } from "../scene/nth";

export type Sampling = "tree" | "candidates";

/** Null of planners with an open list. */
export function samplingOf({ trace: { kinds } }: SearchReplay): Sampling | null {
  return kinds[0] === STEP.drawn ? "tree" : kinds[0] === STEP.candidate ? "candidates" : null;
}

const BEGIN: Record<Sampling, Key> = { tree: "begin.tree", candidates: "begin.candidates" };

/** What there is before the first step. */
export const beginOf = (replay: SearchReplay): Key => {
  const sampling = samplingOf(replay);
  return sampling ? BEGIN[sampling] : "begin";
};

/** What such a step did, in a sentence or two. */
export function sampleLine(lang: Lang, replay: SearchReplay, step: number): string {
  const { trace } = replay,
    first = nth(trace.first, step);
  if (replay.kindOf(step) === STEP.drawn)
    return say(lang, "drawn", {
      place: placeOfStep(lang, replay, step),
      cell: placeOf(lang, replay, 0, nth(trace.targets, first)),
      d: cost(lang, replay, nth(trace.h, step)),
    });
  const legs = nth(trace.first, step + 1) - first,
    blocked = blockedLegs(replay, step);
  const values = { n: step + 1, f: cost(lang, replay, nth(trace.f, step)), blocked, legs };
  if (blocked > 0) return say(lang, "candidate.blocked", values);
  const isBest = trace.f.subarray(0, step).every((f, at) => f > nth(trace.f, step) || blockedLegs(replay, at) > 0);
  return `${say(lang, "candidate.free", values)}${isBest ? ` ${say(lang, "candidate.best")}` : ""}`;
}

function blockedLegs({ trace: { first, fates } }: SearchReplay, step: number): number {
  return fates.subarray(first[step], first[step + 1]).filter((fate) => fate === FATE.blocked).length;
}

const FATES: Record<Sampling, Partial<Record<FateName, Key>>> = {
  tree: { drawn: "fate.drawn", kept: "fate.grown", closed: "fate.inTree" },
  candidates: { drawn: "fate.freeLeg", blocked: "fate.blockedLeg" },
};

/** What became of a move, where these planners have words of their own. */
export const sampleFate = (replay: SearchReplay, fate: FateName): Key | undefined => {
  const sampling = samplingOf(replay);
  return sampling ? FATES[sampling][fate] : undefined;
};

export const SAMPLING_CODE: Record<Sampling, [Role, number, Key][]> = {
  tree: [
    ["init", 0, "code.tree"],
    ["while", 0, "code.whileBudget"],
    ["drawn", 1, "code.draw"],
    ["pop", 1, "code.nearest"],
    ["each", 1, "code.leg"],
    ["blocked", 1, "code.blockedLeg"],
    ["closed", 1, "code.inTree"],
    ["push", 1, "code.grow"],
    ["goal", 1, "code.goalTree"],
    ["end", 0, "code.end"],
  ],
  candidates: [
    ["init", 0, "code.people"],
    ["while", 0, "code.whileBudget"],
    ["pop", 1, "code.child"],
    ["drawn", 1, "code.fitness"],
    ["blocked", 1, "code.price"],
    ["each", 1, "code.generation"],
    ["end", 0, "code.fittest"],
  ],
};
