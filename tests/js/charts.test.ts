/** The charts' quantities, and gears in time. */
import { describe, expect, it } from "vitest";
import type { Drive, Plan } from "parkade";
import { extentOf, pathOf, plotsOf, seriesOf, valueAt, type Line } from "../../www/src/panels/chart-lines";
import { createStore, emptyResult } from "../../www/src/store";
import { gearsOfDrive, gearsOfPath, gearsOfTimeline } from "../../www/src/view/gears";

/** A metre ahead in two seconds, a second's standstill in which the wheel turns by 0.1 rad, a metre back. */
const drive: Drive = {
  t: Float64Array.of(0, 1, 2, 3, 4, 5),
  stations: Float64Array.of(0, 0.5, 1, 1, 1.5, 2),
  path: Float64Array.from([0, 0.5, 1, 1, 0.5, 0].flatMap((x) => [x, 0, 0])),
  speeds: Float64Array.of(0, 1, 0, 0, -1, 0),
  accelerations: Float64Array.of(1, -1, 0, -1, 1, 0),
  steering: Float64Array.of(0, 0, 0, 0.1, 0.1, 0.1),
  hash: "",
};
const plan = {
  outcome: "found",
  path: Float64Array.of(0, 0, 0, 1, 0, 0, 0, 0, 0),
  directions: Int8Array.of(1, -1, -1),
  curvatures: Float64Array.of(0, 0.03, 0.03),
  clearances: Float64Array.of(1, 0.5, 1),
  check: { drivable: true },
  metrics: { curvatureLimit: 0.2, length: 2 },
} as unknown as Plan;
const line: Line = { colour: "red", dash: "none", plan, drive, timed: true };
const state = createStore({
  planners: ["hybrid"],
  results: { hybrid: { ...emptyResult, plan, drive, status: "done" } },
}).state;

describe("gears", () => {
  it("change where the car moves on, in time, and at their place along the path", () => {
    expect(gearsOfDrive(drive)).toEqual({ reverse: [[3, 5]], changes: [3] });
    expect(gearsOfPath(plan)).toEqual({ reverse: [[1, 2]], changes: [1] });
    expect(gearsOfTimeline(state)).toEqual({ reverse: [[0.6, 1]], changes: [0.6] });
  });

  it("of a drive that begins in reverse, or never moves, are told", () => {
    const back = { ...drive, speeds: drive.speeds.map((v) => -v) };
    expect(gearsOfDrive(back)).toEqual({ reverse: [[0, 3]], changes: [3] });
    expect(gearsOfDrive({ ...drive, speeds: new Float64Array(6) })).toEqual({ reverse: [], changes: [] });
  });
});

describe("a chart", () => {
  it("tells a standstill's moments apart, which are one place of the path", () => {
    const at = (clock: number | null) => ({ at: 1, clock });
    expect(valueAt(line, "speed", { at: 0.25, clock: 0.5 })).toBe(0.5);
    expect(valueAt(line, "steering", at(2))).toBe(0);
    expect(valueAt(line, "steering", at(2.5))).toBeCloseTo(0.05 * (180 / Math.PI), 9);
    expect(valueAt(line, "steeringRate", at(2.5))).toBeCloseTo(0.1 * (180 / Math.PI), 9);
    expect(valueAt(line, "acceleration", at(1.9))).toBe(-1);
    expect(valueAt(line, "curvature", at(2.5))).toBe(0.03);
    expect(valueAt(line, "clearance", { at: 0.5, clock: 1 })).toBe(0.75);
    expect(valueAt({ ...line, drive: null }, "speed", at(null))).toBeNull();
    expect(valueAt({ ...line, plan: null }, "clearance", at(1))).toBeNull();
  });

  it("has the quantities of its axis, which ends with the longest line", () => {
    const quantities = (axis: "path" | "time"): string[] =>
      plotsOf(state, [line], axis).map(({ quantity }) => quantity);
    expect(quantities("path")).toEqual(["curvature", "clearance", "speed"]);
    expect(quantities("time")).toEqual(["speed", "acceleration", "steering", "steeringRate"]);
    expect([extentOf([line], "path"), extentOf([line], "time")]).toEqual([2, 5]);
    const guest: Line = { ...line, plan: null, drive: { ...drive, t: drive.t.map((t) => 2 * t) } };
    expect([extentOf([line, guest], "path"), extentOf([line, guest], "time")]).toEqual([2, 10]);
    const blank = plotsOf(state, [{ ...line, drive: null }], "time");
    expect(blank.every((plot) => plot.blank)).toBe(true);
  });

  it("joins what is linear between rows and steps where a value holds", () => {
    const plots = plotsOf(state, [line], "time");
    expect(seriesOf(line, "speed")).toMatchObject({ steps: false });
    expect(pathOf(plots[0]!, line, "time", 5)).toMatch(/^M0\.0 [\d.]+(L[\d.]+ [\d.]+){4,5}$/);
    expect(pathOf(plots[1]!, line, "time", 5)).toMatch(/^M0\.0 [\d.]+(H[\d.]+V[\d.]+)+$/);
    // Along the path a standstill has no width.
    expect(pathOf(plotsOf(state, [line], "path")[2]!, line, "path", 2)).not.toContain("NaN");
    expect(pathOf(plots[0]!, { ...line, drive: null }, "time", 5)).toBe("");
  });

  it("of a trajectory's path has a curvature without steps", () => {
    const made = { ...drive, steeringRates: new Float64Array(6) } as Drive;
    expect(seriesOf(line, "curvature")!.steps).toBe(true);
    expect(seriesOf({ ...line, drive: made }, "curvature")!.steps).toBe(false);
  });
});
