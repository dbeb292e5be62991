/** `parkade/worker`: planners in threads, with the plans of the package itself. */
import { execFileSync } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { afterAll, afterEach, beforeAll, expect, test, vi } from "vitest";
import { generateScenario, init, optimise, Planner, planners, scenario, scenarios, type Plan } from "parkade";
import { createPlanner, createPool, latest, ParkadeError, transferables, type Pool } from "parkade/worker";
import { installed, PACKAGE, slowly } from "./pack";

let folder = "";
const pools: Pool[] = [];
const pool = (...options: Parameters<typeof createPool>): Pool => {
  const made = createPool(...options);
  pools.push(made);
  return made;
};

beforeAll(async () => {
  await init();
  folder = installed();
}, 120_000);
afterAll(() => rmSync(folder, { recursive: true, force: true }));
afterEach(() => {
  for (const one of pools.splice(0)) one.close();
});

const refused = async (asked: Promise<unknown>): Promise<ParkadeError> => {
  const error = await asked.then(
    () => null,
    (thrown: unknown) => thrown,
  );
  expect(error).toBeInstanceOf(ParkadeError);
  return error as ParkadeError;
};

/** Takes seconds, and says that it goes on. */
const long = () => ({ ...scenario("perpendicular"), obstacles: slowly(4000) });

test("each planner's plans on the built-in scenes are those of the package, in two threads", async () => {
  const threads = pool({ size: 2 });
  const ids = planners().map(({ id }) => id);
  const cases = scenarios().flatMap(({ id }, i) => [[id, ids[i % ids.length]!] as const]);
  const compared = cases.map(async ([id, planner]) => {
    const scene = scenario(id);
    let here: Plan | string;
    try {
      here = new Planner(planner, scene).plan();
    } catch (error) {
      here = (error as ParkadeError).message;
    }
    if (typeof here === "string") {
      expect((await refused(threads.createPlanner(planner, scene))).message).toBe(here);
      return;
    }
    const there = await threads.createPlanner(planner, scene);
    const plan = await there.plan();
    expect([id, planner, plan.hash]).toEqual([id, planner, here.hash]);
    expect(plan.path).toEqual(here.path);
    there.free();
  });
  await Promise.all(compared);
});

test("progress, better plans, rasters, sets of paths and trajectories come from the thread", async () => {
  const scene = scenario("L2");
  const planner = await pool({ size: 1 }).createPlanner("hybrid", scene);
  const counts: number[] = [],
    better: string[] = [];
  const plan = await planner.plan({
    alternatives: true,
    layers: ["clearance"],
    onProgress: (expansions) => counts.push(expansions),
    onImproved: ({ hash }) => better.push(hash),
  });
  const here = new Planner("hybrid", scene);
  const told: string[] = [];
  const same = here.plan({ alternatives: true, onImproved: ({ hash }) => told.push(hash) });
  expect(plan.hash).toBe(same.hash);
  expect(plan.alternatives?.map(({ hash }) => hash)).toEqual(same.alternatives?.map(({ hash }) => hash));
  expect(counts.at(-1)).toBeGreaterThan(0);
  expect(told.length).toBeGreaterThan(0);
  expect(better).toEqual(told);
  expect(plan.layers.clearance?.data).toEqual(here.layer("clearance").data);
  expect((await planner.optimise(await planner.plan())).hash).toBe(optimise(scene, here.plan()).hash);
});

test("expansions come while it searches, whole and in order", async () => {
  const planner = await createPlanner("eight", scenario("random-60"));
  const cells: number[] = [];
  const plan = await planner.plan({
    onExpanded: (events) => {
      if (events.kind === "cells") cells.push(...events.cells);
    },
  });
  expect(cells).toEqual([...(plan.trace as { cells: Uint32Array }).cells]);
  planner.free();
});

test("a signal ends the search that runs and the plans that wait, with its reason; the next is whole", async () => {
  const scene = long();
  const planner = await pool({ size: 1 }).createPlanner("hybrid", scene);
  const running = new AbortController(),
    waiting = new AbortController();
  const first = planner.plan({ signal: running.signal, onProgress: () => running.abort("seen enough") }),
    second = planner.plan({ signal: waiting.signal });
  waiting.abort();
  await expect(second).rejects.toMatchObject({ name: "AbortError" });
  await expect(first).rejects.toBe("seen enough");
  await expect(planner.plan({ signal: AbortSignal.abort("before") })).rejects.toBe("before");
  await planner.update(scenario("perpendicular"));
  expect((await planner.plan()).hash).toBe(new Planner("hybrid", scenario("perpendicular")).plan().hash);
});

test("what a callback throws ends the search and is what the promise rejects with", async () => {
  const planner = await pool({ size: 1 }).createPlanner("hybrid", scenario("perpendicular"));
  const oops = new RangeError("mine");
  await expect(
    planner.plan({
      onProgress: () => {
        throw oops;
      },
    }),
  ).rejects.toBe(oops);
  expect((await planner.plan()).outcome).toBe("found");
});

test("bad input is refused as by the package, and leaves the planner as it was", async () => {
  const scene = scenario("perpendicular"),
    threads = pool({ size: 1 });
  const planner = await threads.createPlanner("hybrid", scene);
  const wrong: [() => Promise<unknown>, string, string][] = [
    [() => threads.createPlanner("hybrid", 4 as never), "bad-scenario", "scene"],
    [() => threads.createPlanner("hybird" as never, scene), "unknown-planner", ""],
    [() => threads.createPlanner(3 as never, scene), "bad-input", "planner"],
    [() => threads.createPlanner("hybrid", scene, { reverseCost: -1 }), "bad-config", "reverseCost"],
    [() => threads.createPlanner("hybrid", { ...scene, goal: [1n] as never }), "bad-scenario", "goal[0]"],
    [() => threads.createPlanner("hybrid", { ...scene, toJSON: () => 1n } as never), "bad-input", "scene"],
    [() => planner.update({ ...scene, start: 5 as never }), "bad-scenario", "start"],
    [() => planner.plan({ prefr: "widest" } as never), "bad-input", "prefr"],
    [() => planner.plan({ signal: 5 as never }), "bad-input", "signal"],
    [() => planner.plan({ onProgress: 5 as never }), "bad-input", "onProgress"],
    [() => planner.plan({ layers: "clearance" as never }), "bad-input", "layers"],
    [() => planner.plan(null as never), "bad-input", "options"],
    [() => planner.optimise(undefined as never), "bad-input", "plan"],
    [() => planner.optimise({ path: [1, 2] }), "bad-input", "plan.path"],
  ];
  for (const [asked, code, path] of wrong) expect(await refused(asked())).toMatchObject({ code, path });
  expect((await planner.plan()).hash).toBe(new Planner("hybrid", scene).plan().hash);
  for (const size of [0, 1.5, 257, "4" as never]) expect(() => createPool({ size })).toThrow(/^size: must be/);
  expect(() => createPool({ spawn: 3 as never })).toThrow(/^spawn: must be/);
  expect(await refused(pool({ wasm: "bogus.wasm" }).createPlanner("eight", scene))).toMatchObject({ path: "wasm" });
  expect(await refused(pool({ wasm: 7 as never }).createPlanner("eight", scene))).toMatchObject({ path: "wasm" });
});

test("the scene is the one that was given, though it is changed or is a proxy", async () => {
  const scene = generateScenario({ family: "random", size: 40, seed: 7 });
  const hash = new Planner("eight", scene).plan().hash;
  const handler: ProxyHandler<object> = {
    get: (target, key) => {
      const value: unknown = Reflect.get(target, key);
      return typeof value === "object" && value !== null ? new Proxy(value, handler) : value;
    },
  };
  const planner = await pool({ size: 1 }).createPlanner("eight", new Proxy(scene, handler) as typeof scene);
  scene.obstacles = [];
  expect((await planner.plan()).hash).toBe(hash);
});

test("more planners than threads take turns, and each keeps its own scene and last path", async () => {
  const threads = pool({ size: 2 }),
    ids = ["perpendicular", "parallel", "angled", "L1", "L2"];
  const made = await Promise.all(ids.map((id) => threads.createPlanner("hybrid", scenario(id))));
  const hashes = ids.map((id) => new Planner("hybrid", scenario(id)).plan().hash);
  for (let round = 0; round < 3; round++) {
    const plans = await Promise.all(made.map((planner) => planner.plan({ stickiness: 0.5 })));
    expect(plans.map(({ outcome }) => outcome)).toEqual(ids.map(() => "found"));
    if (round === 0) expect(plans.map(({ hash }) => hash)).toEqual(hashes);
  }
});

test("a planner that is freed ends what runs, refuses what waits and comes; its thread goes to another", async () => {
  const threads = pool({ size: 1 });
  const planner = await threads.createPlanner("hybrid", long());
  const asked = [planner.plan(), planner.plan()];
  planner.free();
  planner.free();
  for (const one of [...asked, planner.plan()]) expect(await refused(one)).toMatchObject({ code: "freed" });
  const next = await threads.createPlanner("eight", scenario("perpendicular"));
  expect((await next.plan()).outcome).toBe("found");
});

test("a thread that dies fails its plan in words, and the planner goes on in another", async () => {
  const { Worker } = await import("node:worker_threads");
  const made: { terminate(): void; onerror: ((event: ErrorEvent) => void) | null }[] = [];
  const threads = pool({
    size: 1,
    spawn: () => {
      const thread = new Worker(join(PACKAGE, "worker/script-node.js"));
      const like = {
        onmessage: null as ((event: MessageEvent) => void) | null,
        onerror: null as ((event: ErrorEvent) => void) | null,
        postMessage: (message: unknown) => thread.postMessage(message),
        terminate: () => void thread.terminate(),
      };
      thread.on("message", (data) => like.onmessage?.({ data } as MessageEvent));
      made.push(like);
      return like;
    },
  });
  const planner = await threads.createPlanner("hybrid", scenario("perpendicular"));
  const asked = planner.plan();
  await vi.waitFor(() => expect(made).toHaveLength(1));
  made[0]!.onerror!({ message: "out of memory" } as ErrorEvent);
  expect((await refused(asked)).message).toBe("the worker stopped: out of memory");
  expect((await planner.plan()).outcome).toBe("found");
  expect(made).toHaveLength(2);
});

test("of calls that overtake each other the newest is answered, the others resolve to undefined", async () => {
  const ran: number[] = [];
  let go = (): void => undefined;
  const newest = latest(async (_, n: number) => {
    ran.push(n);
    await new Promise<void>((done) => {
      go = done;
    });
    return n;
  });
  const asked = [newest(1), newest(2), newest(3)];
  expect(await asked[1]).toBeUndefined();
  go();
  expect(await asked[0]).toBe(1);
  await vi.waitFor(() => expect(ran).toEqual([1, 3]));
  go();
  expect(await asked[2]).toBe(3);
  const failing = latest(() => Promise.reject(new Error("no")));
  await expect(failing()).rejects.toThrow("no");
  expect(() => latest(3 as never)).toThrow(/^run: must be a function/);
  expect(() => latest(async () => 1, { giveUpAfter: -1 })).toThrow(/^giveUpAfter: must be milliseconds/);
});

test("a run that a newer one waits for is given up in time", async () => {
  const newest = latest(
    (signal, n: number) =>
      n > 1
        ? Promise.resolve(n)
        : new Promise<number>((_, failed) => signal.addEventListener("abort", () => failed(signal.reason))),
    { giveUpAfter: 0 },
  );
  expect(await Promise.all([newest(1), newest(2)])).toEqual([undefined, 2]);
});

test("a plan's buffers are each named once", () => {
  const plan = new Planner("hybrid", scenario("L2")).plan({ alternatives: true, trace: true });
  const buffers = transferables(plan);
  expect(new Set(buffers).size).toBe(buffers.length);
  structuredClone(plan, { transfer: buffers });
  expect(plan.path.length + (plan.alternatives?.[0]?.path.length ?? 0)).toBe(0);
});

test("the installed package plans in threads, and a process that has done so ends by itself", () => {
  const guide = readFileSync(new URL("../../docs/guide.md", import.meta.url), "utf8");
  const script = /```js\n([^`]*parkade\/worker[^]*?)```/.exec(guide)![1]!;
  writeFileSync(join(folder, "guide.mjs"), script);
  const out = execFileSync(process.execPath, ["guide.mjs"], { cwd: folder, encoding: "utf8" });
  expect(out.trim().split("\n").length).toBe(script.split("console.log").length - 1);
});

test("the common pool is there without being made", async () => {
  const planner = await createPlanner("eight", scenario("perpendicular"));
  expect((await planner.plan()).hash).toBe(new Planner("eight", scenario("perpendicular")).plan().hash);
  planner.free();
});
