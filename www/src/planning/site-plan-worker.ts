/** Reads a site plan beside the page: a file of 50 MB takes seconds. */
import type { SitePlan } from "parkade/siteplan";
import { readSitePlan } from "../siteplan/read-site-plan";
import { SitePlanError } from "../siteplan/site-plan";

export interface SitePlanFile {
  name: string;
  bytes: Uint8Array;
}
export type SitePlanReply = { plan: SitePlan } | { message: string; line?: number | undefined };

self.onmessage = ({ data: { name, bytes } }: MessageEvent<SitePlanFile>): void => {
  let reply: SitePlanReply;
  try {
    reply = { plan: readSitePlan(name, bytes) };
  } catch (error) {
    reply = {
      message: error instanceof Error ? error.message : String(error),
      ...(error instanceof SitePlanError ? { line: error.line } : {}),
    };
  }
  self.postMessage(reply);
};
