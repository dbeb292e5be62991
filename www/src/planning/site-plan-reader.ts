/** Site plans from files, read in a worker that ends with its file. */
import type { SitePlan } from "parkade/siteplan";
import { MOST_BYTES, SitePlanError } from "../siteplan/site-plan";
import type { SitePlanFile, SitePlanReply } from "./site-plan-worker";

export async function sitePlanOf(file: File): Promise<SitePlan> {
  if (file.size > MOST_BYTES)
    throw new SitePlanError(
      `a site plan must have at most ${MOST_BYTES / 1e6} MB, got ${Math.ceil(file.size / 1e6)} MB`,
    );
  const bytes = new Uint8Array(await file.arrayBuffer());
  const worker = new Worker(new URL("./site-plan-worker.ts", import.meta.url), { type: "module", name: "site plan" });
  try {
    const reply = await new Promise<SitePlanReply>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<SitePlanReply>) => resolve(data);
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new SitePlanError(event.message || "the worker stopped"));
      };
      const request: SitePlanFile = { name: file.name, bytes };
      worker.postMessage(request, [bytes.buffer]);
    });
    if ("plan" in reply) return reply.plan;
    throw new SitePlanError(reply.message, reply.line);
  } finally {
    worker.terminate();
  }
}
