import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Worker } from "node:worker_threads";
import { asyncBufferFromFile, parquetReadObjects } from "hyparquet";
import {
  affectedRows,
  audit,
  auditInParts,
  checkPath,
  generateLot,
  init,
  lotPresets,
  Planner,
  scenario,
  sceneGeometry,
  vehicles,
  type AuditOptions,
  type AuditRow,
  type Scenario,
} from "parkade";
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

/** A lot whose questions take a test's time. */
const small = (): Scenario => generateLot({ seed: 4, rows: 2, bays: 5, angle: Math.PI / 2, aisle: 6, ramp: 0 }).scene;

describe("an audit in parts", () => {
  const whole = (): AuditRow[] => audit(small(), { whatIf: "each-free" });

  it("has the rows of the whole for any number of workers and bays in a part", async () => {
    const rows = whole();
    for (const [workers, bays] of [
      [1, 10],
      [2, 3],
      [8, 1],
    ] as const) {
      const parts: number[] = [];
      const found = await auditInParts(
        small(),
        { whatIf: "each-free" },
        async (scene, options) => {
          // Later parts may be there first.
          await new Promise((done) => setTimeout(done, (Number(options.bays?.[0]) * 7) % 5));
          return audit(scene, options);
        },
        { workers, bays, onProgress: ({ done }) => parts.push(done) },
      );
      expect(found).toEqual(rows);
      expect(parts.at(-1)).toBe(10);
    }
  }, 60_000);

  it("is the same from threads and from the command", async () => {
    const rows = whole(),
      folder = mkdtempSync(join(tmpdir(), "parkade-audit-"));
    const code = `const { parentPort } = require("node:worker_threads");
      import(${JSON.stringify(new URL("../../pkg/node.js", import.meta.url).href)}).then(async ({ audit, init }) => {
        await init();
        parentPort.on("message", ({ scene, options }) => parentPort.postMessage(audit(scene, options)));
      });`;
    const threads = Array.from({ length: 3 }, () => new Worker(code, { eval: true }));
    const free = [...threads];
    const found = await auditInParts(
      small(),
      { whatIf: "each-free" },
      async (scene, options) => {
        const thread = free.pop()!;
        const answer = new Promise<AuditRow[]>((done) => thread.once("message", done));
        thread.postMessage({ scene, options });
        const part = await answer;
        free.push(thread);
        return part;
      },
      { workers: 3, bays: 2 },
    );
    expect(found).toEqual(rows);
    await Promise.all(threads.map((thread) => thread.terminate()));

    writeFileSync(join(folder, "lot.json"), JSON.stringify(small()));
    const command = fileURLToPath(new URL("../../pkg/cli/main.js", import.meta.url));
    for (const jobs of ["1", "2", "8"]) {
      const { stdout, status } = spawnSync(
        process.execPath,
        [command, "audit", "lot.json", "--format", "json", "--jobs", jobs, "--csv", "out.csv", "--svg", "out.svg"],
        { cwd: folder, encoding: "utf8" },
      );
      expect(status).toBe(rows.every(({ reachable }) => reachable) ? 0 : 1);
      expect(JSON.parse(stdout)).toEqual(
        JSON.parse(JSON.stringify(rows, (_, one) => (ArrayBuffer.isView(one) ? [...(one as Float64Array)] : one))),
      );
    }
    const lines = readFileSync(join(folder, "out.csv"), "utf8").trim().split("\n");
    expect(lines.length).toBe(rows.length + 1);
    expect(lines[1]).toContain(rows[0]!.hash);
    const svg = readFileSync(join(folder, "out.svg"), "utf8");
    expect(svg.match(/<polygon points="[^"]+" fill="(#|url)/g)?.length).toBe(10);

    writeFileSync(join(folder, "refused.json"), "{}");
    const run = (...words: string[]) =>
      spawnSync(process.execPath, [command, ...words], { cwd: folder, encoding: "utf8" });
    const batch = run(
      "batch",
      "lot.json",
      "refused.json",
      "--task",
      "audit",
      "--what-if",
      "each-free",
      "--out",
      "all.jsonl",
      "--quiet",
    );
    const inReach = rows.every((row) => row.reachable);
    expect(batch.stdout).toContain(
      `2 of 2 audited (2 now): ${inReach ? 1 : 0} with all bays in reach, ${inReach ? 0 : 1} without, 1 refused`,
    );
    expect(run("columns", "all.jsonl", "--out", "all.parquet").stdout).toBe(
      `all.parquet: 2 results, ${rows.length + 1} rows\n`,
    );
    const buffer = await asyncBufferFromFile(join(folder, "all.parquet"));
    const table = await parquetReadObjects({ file: buffer });
    expect(
      table.filter(({ bay }) => bay !== null).map((row) => [row["hash"], row["out_hash"], Number(row["moves"])]),
    ).toEqual(rows.map(({ hash, out, moves }) => [hash, out!.hash, moves]));
    expect(table.find(({ bay }) => bay === null)?.["error_message"]).toBeTruthy();
    run("batch", "lot.json", "--planner", "eight", "--out", "all.jsonl", "--quiet");
    expect(run("columns", "all.jsonl").stderr).toContain("audits and plans have different columns");
    rmSync(folder, { recursive: true });
  }, 120_000);

  it("ends when its signal does, with the signal's reason", async () => {
    const stop = new AbortController();
    let parts = 0;
    const going = auditInParts(small(), { whatIf: "each-free" }, (scene, options) => audit(scene, options), {
      workers: 1,
      bays: 1,
      signal: stop.signal,
      onProgress: () => {
        if (++parts === 2) stop.abort(new Error("enough"));
      },
    });
    await expect(going).rejects.toThrow("enough");
    expect(parts).toBe(2);
  });
});

describe("after an edit", () => {
  let lot: Scenario;
  const options: AuditOptions = { vehicles: ["sedan"], whatIf: "each-free" };
  let rows: AuditRow[] = [];
  beforeAll(() => {
    lot = small();
    rows = audit(lot, options);
  }, 60_000);
  const withColumn = (x: number, y: number): Scenario => ({
    ...lot,
    obstacles: [...(lot.obstacles ?? []), { type: "rectangle", id: "post", center: [x, y], size: [0.4, 0.4] }],
  });

  it("of nothing no row is affected, of the floor all are", () => {
    expect(affectedRows(lot, lot, rows, options)).toEqual([]);
    expect(affectedRows(lot, { ...lot, vehicle: "paper" }, rows, options)).toEqual(rows);
  });

  it("rows that are not affected by a new column keep a path that is free", () => {
    for (const [x, y] of [
      [12, 6],
      [16, 8],
      [9, 9.5],
    ] as const) {
      const edited = withColumn(x, y),
        touched = new Set(affectedRows(lot, edited, rows, options));
      expect(touched.size, `${x}, ${y}`).toBeGreaterThan(0);
      for (const row of rows.filter((one) => !touched.has(one))) {
        const slots = edited.slots!.map((slot, index) => (index === row.index ? { ...slot, occupied: false } : slot));
        const check = checkPath({ ...edited, slots }, row.swept.slice(-3));
        expect(check.hits, row.bay).toBe(0);
      }
    }
  });

  it("rows out of reach are affected where something is removed", () => {
    const walled = withColumn(12, 8),
      shut: Scenario = {
        ...walled,
        obstacles: [
          {
            type: "wall",
            points: [
              [5, 0],
              [5, 40],
            ],
            thickness: 0.2,
          },
        ],
      };
    const closed = audit(shut, { ...options, bays: [0, 7] });
    expect(closed.some(({ reachable }) => reachable)).toBe(false);
    expect(affectedRows(shut, lot, closed, options)).toEqual(closed);
    expect(
      affectedRows(shut, { ...shut, obstacles: [...shut.obstacles!, ...walled.obstacles!] }, closed, options),
    ).toEqual([]);
  });
});

describe("drawn lots", () => {
  it("are the same for the same options, and other ones for other seeds", () => {
    expect(generateLot({ seed: 3 })).toEqual(generateLot({ seed: 3 }));
    expect(generateLot({ seed: 3 })).not.toEqual(generateLot({ seed: 4 }));
    expect(() => generateLot({ rows: 0 })).toThrow("rows: must be 1 to 40, got 0");
  });

  it("have ten presets, two of them with 120 bays or more", () => {
    expect(lotPresets().length).toBe(10);
    expect(lotPresets().filter(({ bays }) => bays >= 120).length).toBe(2);
    for (const { id, bays } of lotPresets()) {
      const { scene, entrances } = generateLot({ preset: id });
      expect(sceneGeometry(scene).slots.length).toBe(bays);
      expect(entrances[0]).toEqual(scene.start);
    }
  });
});
