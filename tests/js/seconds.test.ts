/** All places that tell how long a drive takes tell the same: table, clock, timeline, charts, files and the referee. */
import { beforeAll, describe, expect, it } from "vitest";
import {
  init,
  judge,
  Planner,
  scenario as given,
  scenarios,
  toCSV,
  toTrajectoryCSV,
  type Drive,
  type Plan,
  type PlannerId,
} from "parkade";
import { driveOf } from "../../www/src/planning/drive-of";
import { along, marginOf } from "../../www/src/planning/smoother";
import { smoothed } from "../../www/src/planning/trajectories";
import { extentOf, linesOf } from "../../www/src/panels/chart-lines";
import { rowsOf } from "../../www/src/panels/metrics";
import { formatTable } from "../../www/src/panels/table-format";
import { ensureIds } from "../../www/src/scene/model";
import { limitsOn } from "../../www/src/scene/speed-limits";
import { emptyResult, initialState, type PanelResult, type Scene, type State } from "../../www/src/store";
import { played } from "../../www/src/store/results";
import { gearsOfTimeline } from "../../www/src/view/gears";
import { clockOf, durationOf, drivenAt, isEncounter } from "../../www/src/view/playback-time";
const scenario = (id: string) => ensureIds(given(id));

beforeAll(() => init());

/** The groups in which cars park. */
const PARKING = ["parking", "tight", "paper", "moving", "figures"];

function planned(scene: Scene, planner: PlannerId): Plan {
  const made = new Planner(planner, scene),
    plan = made.plan({ trace: false });
  made.free();
  return plan;
}

/** What the page holds of a planner, as its workers answer. */
function resultOf(scene: Scene, planner: PlannerId, smooth: boolean): PanelResult {
  const plan = planned(scene, planner),
    drive = driveOf(scene, plan, "predictive", limitsOn(scene)),
    result: PanelResult = { ...emptyResult, plan, drive, status: "done" };
  if (!smooth || !drive) return result;
  const {
    trajectory,
    drive: driven,
    line,
  } = smoothed({ scene, waiting: "predictive", margin: marginOf(plan), ...plan });
  return {
    ...result,
    smoothed: { of: plan, plan: along(plan, line, trajectory.check), drive: driven, trajectory, failure: null },
  };
}

function stateOf(scene: Scene, smooth: boolean): State {
  const results = { hybrid: resultOf(scene, "hybrid", smooth) };
  const state = { ...initialState(), scene, planners: ["hybrid" as const], focus: "hybrid" as const, results, smooth };
  return { ...state, playback: { ...state.playback, base: "drive", fraction: 1 } };
}

/** Rows of a CSV by their names. */
function read(text: string): Record<string, number>[] {
  const [head = "", ...rows] = text.trim().split("\n"),
    names = head.split(",");
  return rows.map((row) => Object.fromEntries(row.split(",").map((field, i) => [names[i], Number(field)])));
}

/** Metres that the speeds of a CSV in time come to, with the accelerations from each row on. */
const travelled = (rows: Record<string, number>[]): number =>
  rows.slice(1).reduce((sum, { t }, i) => {
    const { v, a, t: from } = rows[i]!,
      time = t! - from!;
    return sum + Math.abs(v! * time + (a! * time * time) / 2);
  }, 0);

/** Seconds that the speeds of a path's CSV come to, standstills left out. */
const moved = (rows: Record<string, number>[]): number =>
  rows.slice(1).reduce((sum, { s, v }, i) => {
    const speed = (Math.abs(v!) + Math.abs(rows[i]!["v"]!)) / 2;
    return sum + (speed > 0 ? (s! - rows[i]!["s"]!) / speed : 0);
  }, 0);

const standing = (t: Float64Array, speeds: Float64Array): number =>
  t.reduce((sum, at, i) => sum + (i > 0 && speeds[i] === 0 && speeds[i - 1] === 0 ? at - t[i - 1]! : 0), 0);

const parking = (): string[] =>
  scenarios()
    .filter(({ group }) => PARKING.includes(group))
    .map(({ id }) => id);

it("a smoothed path keeps the margin that its plan kept", () => {
  let asked = 0;
  for (const { id } of scenarios().filter(({ group }) => PARKING.includes(group))) {
    const { plan, smoothed } = resultOf(scenario(id), "hybrid", true),
      margin = plan && marginOf(plan);
    if (!smoothed || typeof margin !== "number") continue;
    asked++;
    // Clearance is a price to the optimiser and no hard limit.
    const kept = Math.min(margin, plan!.metrics.minClearance!);
    expect(smoothed.plan.metrics.minClearance, id).toBeGreaterThan(kept - 0.02);
  }
  expect(asked).toBeGreaterThan(20);
});

describe("the seconds of a drive", () => {
  it("are the same everywhere, in every built-in scene where a car parks", () => {
    let drives = 0;
    for (const id of parking())
      for (const smooth of [false, true]) {
        const scene = scenario(id),
          state = stateOf(scene, smooth),
          result = state.results["hybrid"]!,
          { plan, drive } = played(result)!;
        if (!drive || (isEncounter(drive) && drive.ending !== "arrived")) continue;
        const name = `${id}, ${smooth ? "smooth" : "planned"}`,
          seconds = drive.t.at(-1)!;
        drives++;
        const [row] = rowsOf(state);
        expect(row!.cells.drive.value, name).toBe(seconds);
        expect(JSON.parse(formatTable(state, "json"))[0].drive, name).toBe(seconds);
        expect(durationOf(state), name).toBe(seconds);
        expect(clockOf(state), name).toBe(seconds);
        expect(extentOf(linesOf(state), "time"), name).toBe(seconds);
        const { pose } = drivenAt(state, plan!, result, 1)!;
        expect([pose.x, pose.y], name).toEqual([...drive.path.slice(-3, -1)]);
        for (const share of [...gearsOfTimeline(state)!.changes, ...gearsOfTimeline(state)!.reverse.flat()]) {
          expect(share, name).toBeGreaterThanOrEqual(0);
          expect(share, name).toBeLessThanOrEqual(1);
        }

        const timed = read(toTrajectoryCSV(drive)),
          path = read(toCSV(scene, plan!, drive));
        expect(timed.at(-1)!["t"], name).toBe(seconds);
        expect(travelled(timed), name).toBeCloseTo(drive.stations.at(-1)!, 2);
        expect(path.at(-1)!["t"], name).toBeCloseTo(seconds, 5);
        // Between the rows of a path speeds rise and fall unseen, the more so where a car moves by centimetres.
        const unseen = 0.02 * seconds + 0.3 * plan!.metrics.directionChanges!;
        expect(Math.abs(moved(path) + standing(drive.t, drive.speeds) - seconds), name).toBeLessThan(unseen);
        const { moving: _, ...still } = scene;
        expect(judge(still, toTrajectoryCSV(drive)).duration, name).toBe(seconds);
      }
    expect(drives).toBeGreaterThan(40);
  });

  it("stand beside the length, the gear changes and the clearance of the path that is driven", () => {
    for (const id of ["perpendicular", "par-7.2"]) {
      const scene = scenario(id),
        [row] = rowsOf(stateOf(scene, true)),
        { smoothed: made, plan } = stateOf(scene, true).results["hybrid"]!,
        { drive, trajectory } = made!;
      const { length, gears, clearance, curvature } = row!.cells;
      expect(length.value, id).toBeCloseTo((drive as Drive).stations.at(-1)!, 4);
      expect(length.value, id).not.toBeCloseTo(plan!.metrics.length, 2);
      expect(gears.value, id).toBe(trajectory!.check.gearChanges);
      expect(clearance.value, id).toBe(trajectory!.check.minClearance);
      expect(curvature.value, id).toBeLessThanOrEqual(1.001 * plan!.metrics.curvatureLimit);
      const [own] = rowsOf(stateOf(scene, false));
      expect(own!.cells.length.value, id).toBe(plan!.metrics.length);
    }
  });

  it("are those of the longest drive for the clock, and each car arrives in its own", () => {
    const scene = scenario("perpendicular"),
      state = stateOf(scene, true),
      fast = state.results["hybrid"]!,
      slow = resultOf(scene, "risk-field", false);
    const both: State = { ...state, planners: ["risk-field", "hybrid"], results: { hybrid: fast, "risk-field": slow } };
    const ends = [fast, slow].map((one) => played(one)!.drive!.t.at(-1)!);
    expect(durationOf(both)).toBe(Math.max(...ends));
    expect(rowsOf(both).map(({ cells }) => cells.drive.value)).toEqual(ends.toReversed());
    const hidden = { ...both, hidden: new Set<PlannerId>(["risk-field", "hybrid"]) };
    expect(durationOf(hidden)).toBe(1);
  });

  it("of a drive among moving boxes are the clock's, however long the paths are that no car drives", () => {
    const scene = scenario("fig16-conflict"),
      state = stateOf(scene, true),
      four = resultOf(scene, "four", false);
    const both: State = { ...state, planners: ["four", "hybrid"], results: { ...state.results, four } };
    expect(four.plan!.metrics.length).toBeGreaterThan(state.results["hybrid"]!.plan!.metrics.length);
    expect(durationOf(both)).toBe(rowsOf(both)[1]!.cells.drive.value);
    const { along } = drivenAt({ ...both, playback: { ...both.playback, fraction: 0.5 } }, four.plan!, four, 1)!;
    expect(along).toBeCloseTo(four.plan!.metrics.length / 2, 1);
  });

  it("are not told of paths that no car drives, nor before they are known", () => {
    const state = stateOf(scenario("perpendicular"), false),
      { drive: _, ...rest } = state.results["hybrid"]!;
    const during: State = { ...state, results: { hybrid: { ...rest, drive: null } } };
    expect(rowsOf(during)[0]!.cells.drive).toMatchObject({ value: null, text: "…", best: false });
    const eight = resultOf(scenario("perpendicular"), "eight", true);
    const grid: State = { ...state, planners: ["eight"], focus: "eight", results: { eight } };
    expect(rowsOf(grid)[0]!.cells.drive).toMatchObject({ value: null, text: "–" });
    // Its car goes along all the same.
    expect(
      drivenAt({ ...grid, playback: { ...grid.playback, fraction: 0.5 } }, eight.plan!, eight, 1)!.along,
    ).toBeGreaterThan(1);
  });
});
