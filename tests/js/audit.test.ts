import { audit, init, Planner, scenario, vehicles, type AuditOptions, type AuditRow, type Scenario } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";

beforeAll(() => init());

const scene = (): Scenario => scenario("perpendicular");
const OPTIONS: AuditOptions = { vehicles: ["sedan", "german-car"], whatIf: "each-free" };

const keyOf = ({ index, vehicle, entrance, entry }: AuditRow): string => `${index} ${vehicle} ${entrance} ${entry}`;

describe("an audit", () => {
  it("has a row for each bay, vehicle, entrance and entry, in that order", () => {
    const rows = audit(scene(), OPTIONS);
    const wanted = scene().slots!.flatMap((_, index) =>
      ["sedan", "german-car"].flatMap((vehicle) =>
        ["head-in", "reverse-in"].map((entry) => `${index} ${vehicle} start ${entry}`),
      ),
    );
    expect(rows.map(keyOf)).toEqual(wanted);
  });

  it("leaves occupied bays out unless they are asked as if free", () => {
    const free = scene().slots!.flatMap(({ occupied }, index) => (occupied ? [] : [index]));
    expect(free.length).toBeLessThan(scene().slots!.length);
    expect([...new Set(audit(scene()).map(({ index }) => index))]).toEqual(free);
  });

  it("gives the rows of the whole in parts, in any order of the parts", () => {
    const whole = audit(scene(), OPTIONS),
      bays = scene().slots!.map((_, index) => index);
    const parts = bays.toReversed().map((bay) => audit(scene(), { ...OPTIONS, bays: [bay] }));
    expect(parts.reverse().flat()).toEqual(whole);
    expect(audit(scene(), { ...OPTIONS, bays: [3, 0] })).toEqual(
      whole.filter(({ index }) => index === 0 || index === 3),
    );
  });

  it("says of a way in what the planner says of it", () => {
    const lot = scene(),
      free = lot.slots!.find(({ occupied, id }) => !occupied && id !== undefined)!.id!;
    for (const row of audit(lot, { bays: [free] })) {
      const planner = new Planner("hybrid", lot);
      const plan = planner.plan({ goal: { slot: free, entry: row.entry } });
      planner.free();
      expect([row.hash, row.moves, row.length, row.clearance]).toEqual([
        plan.hash,
        plan.metrics.directionChanges + 1,
        plan.metrics.length,
        plan.metrics.minClearance,
      ]);
      expect(plan.check.verdict).toBe("ok");
    }
  });

  it("names what stands in the way of a vehicle that does not fit", () => {
    const rows = audit(scene(), { vehicles: ["small-lorry"], whatIf: "each-free" });
    const blocked = rows.filter(({ reachable }) => !reachable);
    expect(blocked.length).toBeGreaterThan(0);
    for (const row of blocked) {
      expect(row.reason).toMatch(/\.$/);
      expect([row.moves, row.driveTime]).toEqual([0, null]);
    }
    expect(rows.every(({ overhang }) => overhang > 0)).toBe(true);
  });

  it("gives each row at once, and ends where it is told to", () => {
    const told: AuditRow[] = [];
    const rows = audit(scene(), { ...OPTIONS, onRow: (row) => told.push(row) < 3 });
    expect(told).toEqual(rows);
    expect(rows.length).toBe(3);
    expect(() =>
      audit(scene(), {
        onRow: () => {
          throw new Error("enough");
        },
      }),
    ).toThrow("enough");
  });

  it("refuses wrong options by field, value and rule", () => {
    const refused = (options: unknown): string => {
      try {
        audit(scene(), options as AuditOptions);
      } catch (error) {
        return String(error);
      }
      return "accepted";
    };
    expect(refused({ vehicles: ["lorry"] })).toMatch(/vehicles\[0\]: must be .*german-car.*, got "lorry"/);
    expect(refused({ vehicles: [] })).toMatch(/vehicles: must have 1 to 10000 items, got 0/);
    expect(refused({ vehicles: ["sedan", "sedan"] })).toMatch(/vehicles: must have different ids, got "sedan" twice/);
    expect(refused({ bays: ["nowhere"] })).toMatch(/bays\[0\]: must be the id or index of one of \d+ slots/);
    expect(refused({ entries: ["sideways"] })).toMatch(/entries\[0\]: must be head-in or reverse-in/);
    expect(refused({ whatIf: "all-free" })).toMatch(/whatIf: must be as-is or each-free/);
    expect(refused({ colour: 1 })).toMatch(/colour: unknown field/);
    expect(refused({ entrances: [{ id: "a", pose: { x: 1, y: 2 } }] })).toMatch(/entrances\[0\]\.pose\.heading/);
  });
});

it("every vehicle of the library can be audited with", () => {
  for (const { id, vehicle } of vehicles()) {
    const [one] = audit(scene(), { vehicles: [id], bays: [0], whatIf: "each-free", out: false });
    const [other] = audit(scene(), { vehicles: [{ id, vehicle }], bays: [0], whatIf: "each-free", out: false });
    expect(other).toEqual(one);
  }
});
