import { beforeEach, expect, test, vi } from "vitest";

/** The module's exports, as they behave when something is wrong inside. */
const raw = vi.hoisted(() => ({
  default: vi.fn(async () => undefined),
  initSync: vi.fn(),
  version: () => {
    throw new WebAssembly.RuntimeError("unreachable");
  },
  planners: () => {
    throw new TypeError("a bug in the glue");
  },
  scenarios: () => [],
  RawPlanner: class {
    static freed = 0;
    free() {
      raw.RawPlanner.freed += 1;
    }
  },
}));
vi.mock("../../pkg/parkade.js", () => raw);

/** The package as a new worker sees it. */
async function fresh() {
  vi.resetModules();
  return import("parkade");
}

beforeEach(() => {
  raw.initSync.mockClear();
  raw.RawPlanner.freed = 0;
});

test("a trap is an internal error, and nothing is called after it", async () => {
  const { Planner, init, scenarios, version } = await fresh();
  await init();
  const planner = new Planner("eight", {} as never);
  expect(version).toThrow(expect.objectContaining({ name: "ParkadeError", code: "internal", path: "" }));
  expect(scenarios).toThrow(expect.objectContaining({ code: "internal" }));
  await init();
  expect(scenarios).toThrow(expect.objectContaining({ code: "internal" }));
  planner.free();
  expect(raw.RawPlanner.freed).toBe(0);
});

test("another unexpected error is internal too, with its cause, and the module goes on", async () => {
  const { init, planners, scenarios } = await fresh();
  await init();
  expect(planners).toThrow(expect.objectContaining({ code: "internal", cause: expect.any(TypeError) }));
  expect(scenarios()).toEqual([]);
});

test("memory is given back once", async () => {
  const { Planner, init } = await fresh();
  await init();
  const planner = new Planner("eight", {} as never);
  planner.free();
  planner[Symbol.dispose]();
  expect(raw.RawPlanner.freed).toBe(1);
});

test("init loads once, and again only after it failed", async () => {
  const { init } = await fresh();
  raw.initSync.mockImplementationOnce(() => {
    throw new Error("no room");
  });
  await expect(Promise.all([init(), init()])).rejects.toMatchObject({
    code: "internal",
    message: expect.stringContaining("no room"),
  });
  expect(raw.initSync).toHaveBeenCalledTimes(1);
  await Promise.all([init(), init()]);
  await init();
  expect(raw.initSync).toHaveBeenCalledTimes(2);
});
