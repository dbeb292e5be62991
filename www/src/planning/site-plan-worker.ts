/** Reads a site plan beside the page: a file of 50 MB takes seconds. */
import type { SitePlan } from "parkade/siteplan";
import { readSitePlan } from "../siteplan/read-site-plan";
import { answerCalls } from "./answer-calls";

const JOBS = {
  read: ({ name, bytes }: { name: string; bytes: Uint8Array }): SitePlan => readSitePlan(name, bytes),
};
export type SitePlanJobs = typeof JOBS;

answerCalls(JOBS);
