/** Reads a site plan and makes scenes of it beside the page: a file of 50 MB takes seconds. */
import type { SitePlan, SitePlanOptions, SitePlanScene } from "parkade/siteplan";
import { buffersOf, outlineOf, type PlanOutline } from "../siteplan/plan-outline";
import { readSitePlan } from "../siteplan/read-site-plan";
import { sceneFromSitePlan } from "../siteplan/site-plan-scene";
import { answerCalls } from "./answer-calls";

let plan: SitePlan | null = null;

const JOBS = {
  read: ({ name, bytes }: { name: string; bytes: Uint8Array }): PlanOutline => {
    plan = readSitePlan(name, bytes);
    return outlineOf(plan);
  },
  scene: (options: SitePlanOptions): SitePlanScene => sceneFromSitePlan(plan!, options),
};
export type SitePlanJobs = typeof JOBS;

const isOutline = (answer: unknown): answer is PlanOutline =>
  typeof answer === "object" && answer !== null && "suggestedUnit" in answer;

answerCalls(JOBS, undefined, (answer) => (isOutline(answer) ? buffersOf(answer) : []));
