import { readFileSync } from "node:fs";
import { init, Planner, planners, scenario, type PlannerId } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import { core } from "./core";

const read = (name: string): unknown => JSON.parse(readFileSync(new URL(`../data/${name}`, import.meta.url), "utf8"));

interface Golden {
  family: string;
  n: number;
  seed: number;
  optimal_cost_micro: Record<string, number>;
  expanded: Record<string, number>;
  generated: Record<string, number>;
  risk: { cost_micro: number; expanded: number; generated: number; deferred: number; length_pruned: number };
}

beforeAll(() => Promise.all([init(), core.init()]));

describe("plans in Node", () => {
  const hashes = read("plan-hashes.json") as Record<string, Record<PlannerId, string>>;

  it.each(Object.keys(hashes))("have the native hashes on %s", (id) => {
    expect(Object.keys(hashes[id]!).sort()).toEqual(
      planners()
        .map((p) => p.id)
        .sort(),
    );
    for (const [planner, hash] of Object.entries(hashes[id]!)) {
      const session = new Planner(planner as PlannerId, scenario(id));
      expect(session.plan().hash, `${planner} on ${id}`).toBe(hash);
      session.free();
    }
  });

  it.each(Object.keys(hashes))("are the same by the smaller module on %s", (id) => {
    const ids = core.planners().map((planner) => planner.id);
    expect(ids).toEqual(["four", "eight", "risk-field", "hybrid", "hybrid-forward"]);
    for (const planner of ids) {
      const session = new core.Planner(planner, core.scenario(id));
      expect(session.plan().hash, `${planner} on ${id}`).toBe(hashes[id]![planner]);
      session.free();
    }
  });

  it.each(["regular", "trap"])("count like the golden vectors on %s-60", (family) => {
    const { maps } = read("grid-golden-vectors.json") as { maps: Golden[] };
    const golden = maps.find((m) => m.family === family && m.n === 60 && m.seed === 7)!;
    const plan = <Id extends PlannerId>(id: Id) => new Planner(id, scenario(`${family}-60`)).plan();
    const four = plan("four").stats,
      eight = plan("eight").stats,
      risk = plan("risk-field");
    expect([four.costMicro, four.expanded, four.generated]).toEqual([
      golden.optimal_cost_micro["a4"],
      golden.expanded["a4_manhattan"],
      golden.generated["a4_manhattan"],
    ]);
    expect([eight.costMicro, eight.expanded, eight.generated]).toEqual([
      golden.optimal_cost_micro["a8"],
      golden.expanded["a8_euclid"],
      golden.generated["a8_euclid"],
    ]);
    expect([risk.stats.costMicro, risk.stats.expanded, risk.stats.generated, risk.stats.deferred]).toEqual([
      golden.risk.cost_micro,
      golden.risk.expanded,
      golden.risk.generated,
      golden.risk.deferred,
    ]);
    expect(risk.metrics.lengthPruned).toBeCloseTo(golden.risk.length_pruned, 6);
  });
});
