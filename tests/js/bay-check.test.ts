/** The check of all bays: the same answers with any number of workers, and after edits. */
import { audit, init, scenario as given, type AuditRow } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import { BayChecker, type BayWorker } from "../../www/src/planning/bay-checker";
import { reportPage } from "../../www/src/panels/bay-report";
import { bayCsv, bayLines } from "../../www/src/panels/bay-rows";
import { ensureIds } from "../../www/src/scene/model";
import type { Scenario } from "../../www/src/scene/scenario";
import { buildLot, firstForm } from "../../www/src/scene/lot";
import { changesBetween, distanceTo } from "../../www/src/scene/scene-changes";
import { createStore, type Store } from "../../www/src/store";
import { bestRow, countBays, gradeOf, type BayCheck } from "../../www/src/store/bay-check";
const scenario = (id: string) => ensureIds(given(id));

beforeAll(async () => {
  await init();
});

const SEDAN = { id: "own", vehicle: "sedan" as const };
const whole = (scene: Scenario): AuditRow[] => audit(scene, { vehicles: [SEDAN], whatIf: "each-free" });

function checked(): BayCheck {
  return {
    vehicle: SEDAN,
    entry: "either",
    rows: new Map(),
    stale: new Set(),
    done: 0,
    of: 0,
    lit: null,
    opened: false,
  };
}

/** Workers that answer in turns of the event loop, and note what they are asked. */
const workers = (asked: number[]) => (): BayWorker => ({
  ask: async (scene, vehicle, bays, entries) => {
    asked.push(...bays);
    await new Promise((done) => setTimeout(done));
    return audit(scene, { vehicles: [vehicle], bays: [...bays], entries: [...entries], whatIf: "each-free" });
  },
  stop: () => {},
});

function settled(store: Store): Promise<BayCheck> {
  return new Promise((resolve) => {
    const look = (): void => {
      const { bays } = store.state;
      if (bays && bays.of > 0 && bays.done === bays.of) {
        stop();
        resolve(bays);
      }
    };
    const stop = store.subscribe(look);
    setTimeout(look);
  });
}

const lot = (): Scenario => {
  const built = buildLot({ ...firstForm, count: 6, sides: "both", every: 3 });
  expect(built.fault).toBeNull();
  return built.scene!;
};
const inOrder = (check: BayCheck): AuditRow[] =>
  [...check.rows.keys()].sort((a, b) => a - b).flatMap((index) => check.rows.get(index)!);

describe("a check of all bays", () => {
  it.each([1, 2, 8])("answers what an audit of the whole does, with %i workers", async (count) => {
    const scene = lot(),
      store = createStore({ scene, bays: checked() });
    const checker = new BayChecker(store, workers([]), (error) => expect.fail(String(error)), SEDAN, count);
    checker.askAll();
    expect(inOrder(await settled(store))).toEqual(whole(scene));
    checker.stop();
  });

  it("asks after an edit first the bays that it touches, and answers what a new check does", async () => {
    const scene = lot(),
      asked: number[] = [],
      store = createStore({ scene, bays: checked() });
    const checker = new BayChecker(store, workers(asked), (error) => expect.fail(String(error)), SEDAN, 1);
    checker.askAll();
    await settled(store);
    asked.length = 0;
    const column = scene.obstacles!.findIndex(({ type }) => type === "rectangle");
    const moved: Scenario = {
      ...scene,
      obstacles: scene.obstacles!.map((one, i) =>
        i === column && one.type === "rectangle" ? { ...one, center: [one.center[0] + 1.2, one.center[1] + 0.4] } : one,
      ),
    };
    store.edit(moved);
    checker.follow(moved);
    const stale = new Set(store.state.bays!.stale);
    expect(stale.size).toBeGreaterThan(0);
    expect(stale.size).toBeLessThan(scene.slots!.length);
    const after = await settled(store);
    expect(inOrder(after)).toEqual(whole(moved));
    expect(new Set(asked.slice(0, stale.size))).toEqual(stale);
    // Those by the column come before those that are only passed by.
    const { boxes } = changesBetween(scene, moved);
    const far = asked.slice(0, stale.size).map((bay) => {
      const { x, y } = scene.slots![bay]!;
      return Math.min(...boxes.map((box) => distanceTo([x, y], box)));
    });
    expect(far).toEqual(far.toSorted((a, b) => a - b));
    // Each bay is asked once, or for one entry first and for the other one later.
    expect([...new Set(asked)].sort((a, b) => a - b)).toEqual(scene.slots!.map((_, i) => i));
    expect(asked.length).toBeLessThanOrEqual(scene.slots!.length + stale.size);
    // What was not held stale has the answer that it had.
    const before = new Map(whole(scene).map((row) => [`${row.index} ${row.entry}`, row]));
    const changed = new Set(
      inOrder(after)
        .filter((row) => before.get(`${row.index} ${row.entry}`)!.moves !== row.moves)
        .map(({ index }) => index),
    );
    expect([...changed].filter((index) => !stale.has(index))).toEqual([]);
    checker.stop();
  });

  it("is over where a worker fails, so that nothing waits for it", async () => {
    const scene = lot(),
      store = createStore({ scene, bays: checked() }),
      failures: string[] = [];
    let left = 3;
    const failing = (): BayWorker => {
      const worker = workers([])();
      const ask: BayWorker["ask"] = (...question) =>
        left-- > 0 ? worker.ask(...question) : Promise.reject(new Error("lost"));
      return { ...worker, ask };
    };
    const checker = new BayChecker(store, failing, (error) => failures.push(String(error)), SEDAN, 1);
    checker.askAll();
    const { done, of, rows } = await settled(store);
    expect([done, of, failures]).toEqual([rows.size, rows.size, ["Error: lost"]]);
    expect(rows.size).toBeLessThan(scene.slots!.length);
    checker.stop();
  });

  it("asks nothing anew where only the goal has changed", () => {
    const scene = scenario("perpendicular");
    const changes = changesBetween(scene, { ...scene, goal: { x: 1, y: 1, heading: 0 } });
    expect(changes).toMatchObject({ everywhere: false, boxes: [] });
    expect(changesBetween(scene, { ...scene, start: { ...scene.start, x: 1 } }).everywhere).toBe(true);
    expect(changesBetween(scene, { ...scene, obstacles: [] }).boxes).toHaveLength(scene.obstacles!.length);
  });
});

describe("the table of bays", () => {
  const tableOf = (): BayCheck => {
    const scene = lot(),
      rows = new Map<number, AuditRow[]>();
    for (const row of whole(scene)) rows.set(row.index, [...(rows.get(row.index) ?? []), row]);
    return { ...checked(), rows };
  };

  it("begins with the worst", () => {
    const check = tableOf(),
      grades = bayLines(check, { column: "worst", descends: false }).map(({ best }) => gradeOf(best) || 99);
    expect(grades).toEqual([...grades].sort((a, b) => b - a));
  });

  it("sorts by every column both ways", () => {
    const check = tableOf();
    for (const column of ["bay", "headIn", "reverseIn", "length", "seconds", "clearance"] as const) {
      const [up, down] = [false, true].map((descends) => bayLines(check, { column, descends }));
      expect(new Set(up!.map(({ index }) => index)).size).toBe(check.rows.size);
      expect(up![0]!.index === down![0]!.index && up!.length > 1 && column === "bay").toBe(false);
    }
  });

  it("takes the better entry, and counts by the one that is asked for", () => {
    const check = tableOf();
    for (const index of check.rows.keys()) {
      const best = bestRow(check, index)!,
        own = bestRow({ ...check, entry: "head-in" }, index)!;
      expect(own.entry).toBe("head-in");
      if (own.reachable) expect(best.moves).toBeLessThanOrEqual(own.moves);
    }
    expect(countBays(check).asked).toBe(check.rows.size);
  });

  it("is a file with a line for each question", () => {
    const check = tableOf(),
      lines = bayCsv(check).trim().split("\r\n");
    expect(lines).toHaveLength(1 + 2 * check.rows.size);
    expect(new Set(lines.map((line) => line.replace(/"[^"]*"/g, "").split(",").length))).toEqual(new Set([14]));
  });
});

it("a lot that is larger than the largest paper is reported without its plan, which a sentence says", () => {
  const lot = scenario("perpendicular");
  const check = checked();
  check.rows = new Map([[0, audit(lot, { vehicles: [SEDAN], bays: [0], whatIf: "each-free" })]]);
  const wide = (width: number): Scenario => ({ ...lot, map: { origin: [0, 0], width, height: 100, resolution: 1 } });
  expect(reportPage(wide(2300), check, "en")).toContain("1:2000");
  for (const [lang, words] of [
    ["en", "At 1:2000 the lot is larger than A0 paper"],
    ["zh", "比例 1:2000 时，场地仍大于 A0 图纸"],
  ] as const) {
    const page = reportPage(wide(2400), check, lang);
    expect(page).toContain(words);
    expect(page).not.toContain("<svg");
    expect(page).toContain("<tbody><tr>");
  }
});
