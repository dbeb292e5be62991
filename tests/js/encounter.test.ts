import { init, Planner, scenario, stopWaitGo } from "parkade";
import { beforeAll, expect, test } from "vitest";
import type { Frame } from "../../www/src/view/frame";
import { marksOf } from "../../www/src/view/layers/encounter";

beforeAll(() => init());

function marks(id: string) {
  const scene = scenario(id),
    planner = new Planner("hybrid", scene),
    plan = planner.plan();
  planner.free();
  const drive = stopWaitGo(scene, plan);
  return { scene, drive, marks: marksOf({ state: { scene } } as unknown as Frame, drive) };
}

test("a wait is marked as in the paper's figure: A to D of the box, S, W, E of the car, in their order", () => {
  const { scene, drive, marks: found } = marks("fig16-wait"),
    of = (name: string) => found.find((one) => one.name === name)!;
  expect(found.map(({ name }) => name).join("")).toBe("ABCDSWE");
  const [first, last] = [scene.moving![0]!.points[0]!, scene.moving![0]!.points.at(-1)!];
  expect([of("A").at, of("D").at]).toEqual([first, last]);
  expect(of("D").t).toBeCloseTo(12.5, 9);
  const [wait] = drive.waits;
  expect([of("W").t, of("B").t, of("C").t]).toEqual([wait!.from, wait!.from, wait!.to]);
  expect(of("W").at).toEqual([wait!.pose.x, wait!.pose.y]);
  // The box drives at 2 m/s from its first point.
  expect(of("B").at[0]).toBeCloseTo(first[0] + 2 * wait!.from, 9);
  expect(of("S").at).toEqual([scene.start.x, scene.start.y]);
  expect(of("E").t).toBe(drive.duration);
  expect(of("A").t <= of("B").t && of("B").t < of("C").t && of("C").t < of("E").t).toBe(true);
});

test("where nothing is waited for nothing is marked", () => {
  expect(marks("fig16").marks).toEqual([]);
});
