/** Site plans from files, read in a worker that ends with its file. */
import type { SitePlan } from "parkade/siteplan";
import { MOST_BYTES, SitePlanError } from "../siteplan/site-plan";
import { CallError, Calls } from "./calls";
import type { SitePlanJobs } from "./site-plan-worker";
import { rule } from "../i18n/rule";

export async function sitePlanOf(file: File): Promise<SitePlan> {
  if (file.size > MOST_BYTES)
    throw new SitePlanError(
      rule`a site plan must have at most ${MOST_BYTES / 1e6} MB, got ${Math.ceil(file.size / 1e6)} MB`,
    );
  const bytes = new Uint8Array(await file.arrayBuffer());
  const reader = new Calls<SitePlanJobs>(
    new Worker(new URL("./site-plan-worker.ts", import.meta.url), { type: "module", name: "site plan" }),
  );
  try {
    return await reader.call("read", { name: file.name, bytes }, [bytes.buffer]);
  } catch (error) {
    throw error instanceof CallError ? new SitePlanError(error, error.line) : error;
  } finally {
    reader.stop();
  }
}
