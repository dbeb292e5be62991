// @ts-check
// The worker's side: answers a client's jobs, one after the other, with one planner at a time.
import { transferables } from "./transfer.js";

/**
 * The package's functions that jobs call.
 * @typedef {Pick<typeof import("../index.js"), "Planner" | "init" | "optimise">} Api
 * @typedef {import("./protocol.js").Job} Job
 * @typedef {import("./protocol.js").Reply} Reply
 * @typedef {{ send(reply: Reply, transfer: ArrayBuffer[]): void,
 *   listen(take: (message: import("./protocol.js").Message) => void): void }} Port
 */

/** Ends a search whose answer nobody wants any more. */
class Stopped extends Error {}

/** @param {Api} api @param {Port} port */
export function serve(api, port) {
  /** @type {Promise<void> | undefined} */
  let ready;
  /** @type {import("../index.js").Planner | undefined} */
  let planner;
  /** @type {import("../index.js").Scenario | undefined} */
  let scene;

  /** @param {NonNullable<Job["prepare"]>} prepare */
  function prepared({ planner: id, scene: next, settings, before }) {
    const last = planner;
    planner = undefined;
    try {
      planner = new api.Planner(id, next, settings);
      scene = next;
      if (before) planner.continueFrom(/** @type {any} */ (before));
    } finally {
      last?.free();
    }
  }

  /** @param {Extract<Job, { kind: "plan" }>} job */
  function planned({ id, options, layers: names, tells, stop }) {
    const held = /** @type {import("../index.js").Planner} */ (planner);
    const flag = stop && new Int32Array(stop);
    const plan = held.plan({
      ...options,
      ...((flag || tells.progress) && {
        onProgress: (expansions) => {
          if (flag && Atomics.load(flag, 0) !== 0) throw new Stopped();
          if (tells.progress) port.send({ kind: "progress", id, expansions }, []);
        },
      }),
      ...(tells.improved && {
        onImproved: (/** @type {import("../index.js").Plan} */ better) =>
          port.send({ kind: "improved", id, plan: better }, transferables(better)),
      }),
      ...(tells.expanded && {
        onExpanded: (/** @type {import("../index.js").Expansions} */ events) =>
          port.send({ kind: "expanded", id, events }, [
            /** @type {ArrayBuffer} */ ((events.kind === "cells" ? events.cells : events.arcs).buffer),
          ]),
      }),
    });
    /** @type {Record<string, import("../index.js").Layer>} */
    const layers = {};
    for (const name of names) layers[name] = held.layer(name);
    const result = names.length > 0 ? { ...plan, layers } : plan;
    port.send({ kind: "done", id, result }, transferables(plan, layers));
  }

  /** @param {Job} job */
  async function answer(job) {
    try {
      await ready;
      if (job.prepare) prepared(job.prepare);
      if (job.kind === "plan") planned(job);
      else if (job.kind === "optimise")
        port.send(
          { kind: "done", id: job.id, result: api.optimise(/** @type {any} */ (scene), job.path, job.options) },
          [],
        );
      else port.send({ kind: "done", id: job.id, result: undefined }, []);
    } catch (error) {
      port.send(error instanceof Stopped ? { kind: "stopped", id: job.id } : failed(job.id, error), []);
    }
  }

  port.listen((message) => {
    if (message.kind === "start") ready = api.init({ wasm: message.module });
    else void answer(message);
  });
}

/** @param {number} id @param {unknown} thrown @returns {Reply} */
function failed(id, thrown) {
  const {
    code = "internal",
    path = "",
    message = String(thrown),
    template,
    values,
  } = /** @type {any} */ (Object(thrown));
  return { kind: "failed", id, error: { code, path, message, template, values } };
}
