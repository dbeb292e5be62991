/** Reads a site plan and makes scenes of it beside the page: a file of 50 MB takes seconds. */
import type { SitePlan, SitePlanOptions, SitePlanScene } from "parkade/siteplan";
import { readSitePlan } from "../siteplan/read-site-plan";
import { sceneFromSitePlan } from "../siteplan/site-plan-scene";
import { answerCalls } from "./answer-calls";

let plan: SitePlan | null = null;

const JOBS = {
  read: ({ name, bytes }: { name: string; bytes: Uint8Array }): SitePlan => {
    plan = readSitePlan(name, bytes);
    return plan;
  },
  scene: (options: SitePlanOptions): SitePlanScene => sceneFromSitePlan(plan!, options),
};
export type SitePlanJobs = typeof JOBS;

answerCalls(JOBS);
