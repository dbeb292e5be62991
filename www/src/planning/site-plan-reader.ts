/** Site plans from files. A worker reads the file, keeps the plan, and makes scenes of it until it is closed. */
import type { SitePlanOptions, SitePlanScene } from "parkade/siteplan";
import type { PlanOutline } from "../siteplan/plan-outline";
import { MOST_BYTES, SitePlanError } from "../siteplan/site-plan";
import { CallError, Calls } from "./calls";
import type { SitePlanJobs } from "./site-plan-worker";
import { rule } from "../i18n/rule";

export class SitePlanReader {
  private readonly calls = new Calls<SitePlanJobs>(
    new Worker(new URL("./site-plan-worker.ts", import.meta.url), { type: "module", name: "site plan" }),
  );

  async read(file: File): Promise<PlanOutline> {
    if (file.size > MOST_BYTES)
      throw new SitePlanError(
        rule`a site plan must have at most ${MOST_BYTES / 1e6} MB, got ${Math.ceil(file.size / 1e6)} MB`,
      );
    const bytes = new Uint8Array(await file.arrayBuffer());
    return this.calls.call("read", { name: file.name, bytes }, [bytes.buffer]).catch(refuse);
  }

  /** The scene that the plan gives, as `sceneFromSitePlan` makes it. */
  scene(options: SitePlanOptions): Promise<SitePlanScene> {
    return this.calls.call("scene", options).catch(refuse);
  }

  /** Ends the worker, whatever it does. */
  close(): void {
    this.calls.stop();
  }
}

function refuse(error: unknown): never {
  throw error instanceof CallError ? new SitePlanError(error, error.line) : error;
}
