/** Trajectories from files: how the page plays what the referee has read. */
import { beforeAll, describe, expect, it } from "vitest";
import { init, judge, optimise, Planner, scenario, toTrajectoryCSV } from "parkade";
import { isTrajectory } from "../../www/src/app/guest";
import { columnsOf, drivenOf } from "../../www/src/planning/trajectory-columns";
import { judged, lineOf } from "../../www/src/planning/trajectories";

beforeAll(() => init());

const WHEELBASE = 3.7;

function plan(id: string) {
  const planner = new Planner("hybrid", scenario(id)),
    found = planner.plan({ trace: false });
  planner.free();
  return found;
}

describe("a trajectory's file", () => {
  it("is told from a parking case by the names in its first line", async () => {
    const file = (name: string, text: string) => new File([text], name);
    expect(await isTrajectory(file("mine.csv", "t,x,y,theta\n0,0,0,0\n"))).toBe(true);
    expect(await isTrajectory(file("mine.CSV", "\ufeff x,y,theta\n"))).toBe(true);
    expect(await isTrajectory(file("case1.csv", "-11.6,5.2,0,10,4,0,1,4,3,2,5,2,5,3,3,3\n"))).toBe(false);
    expect(await isTrajectory(file("scene.json", "t,x,y,theta\n"))).toBe(false);
  });

  it("that we wrote plays as the drive that it was written of", () => {
    const scene = scenario("perpendicular"),
      made = optimise(scene, plan("perpendicular")),
      { verdict, drive } = judged({ scene, text: toTrajectoryCSV(made) });
    expect(verdict).toMatchObject({ passes: true, duration: made.duration });
    expect(drive.t).toEqual(made.t);
    expect(drive.path).toEqual(made.path);
    expect(drive.speeds).toEqual(made.speeds);
    expect(drive.steering).toEqual(made.steering);
    // Chords are shorter than arcs, by little.
    expect(drive.stations.at(-1)).toBeCloseTo(made.length, 3);
    made.accelerations.slice(0, -1).forEach((a, i) => expect(drive.accelerations[i]).toBeCloseTo(a, 6));
  });

  it("without speeds and angles has those of its poses", () => {
    const rows = Array.from({ length: 21 }, (_, i) => {
      const t = i / 10,
        turned = -t / 5;
      return [t, 5 * Math.sin(turned), 5 * (1 - Math.cos(turned)), turned].join(",");
    });
    const drive = drivenOf(columnsOf(`t,x,y,theta\n${rows.join("\r\n")}\n\n`), WHEELBASE, 2);
    expect(drive.speeds[10]).toBeCloseTo(-1, 3);
    expect(drive.steering[10]).toBeCloseTo(Math.atan(WHEELBASE / 5), 3);
    expect([drive.speeds[0], drive.speeds.at(-1)]).toEqual([0, 0]);
  });

  it("without times is driven run by run, in the referee's seconds", () => {
    const text = "x,y,theta,gear\n0,0,0,1\n1,0,0,-1\n0,0,0,1\n1,0,0,1\n",
      drive = drivenOf(columnsOf(text), WHEELBASE, 6);
    expect([...drive.t]).toEqual([0, 2, 4, 6]);
    expect([...drive.stations]).toEqual([0, 1, 2, 3]);
    expect([...drive.speeds]).toEqual([0, 0, 0, 0]);
    const long = drivenOf(columnsOf("x,y,theta\n0,0,0\n1,0,0\n5,0,0\n9,0,0\n10,0,0\n"), WHEELBASE, 6.5);
    // 3.125 m to 2.5 m/s, and as far from it.
    expect(long.t[1]).toBeCloseTo(Math.SQRT2, 9);
    expect(long.t[2]).toBeCloseTo(3.25, 9);
    expect(long.t.at(-1)).toBe(6.5);
  });

  it("is played in the time that the referee says, whatever it lacks", () => {
    const scene = scenario("reverse-in"),
      { path, directions } = plan("reverse-in");
    const rows = Array.from(directions, (gear, i) => [...path.subarray(3 * i, 3 * i + 3), gear].join(","));
    const { verdict, drive } = judged({ scene, text: `x,y,theta,gear\n${rows.join("\n")}` });
    expect(verdict.duration).toBe(judge(scene, { path, directions }).duration);
    expect(drive.t.at(-1)).toBeCloseTo(verdict.duration, 9);
    expect(drive.t.every((t, i) => i === 0 || t >= drive.t[i - 1]!)).toBe(true);
  });
});

describe("the path of a drive", () => {
  it("has no standstills, and every pose has the gear and the curvature of the way on", () => {
    const made = optimise(scenario("reverse-in"), plan("reverse-in")),
      { path, directions, curvatures } = lineOf(made, WHEELBASE);
    expect(path.length).toBe(3 * directions.length);
    expect(curvatures.length).toBe(directions.length);
    const changes = directions.reduce((sum, gear, i) => sum + Number(i > 0 && gear !== directions[i - 1]), 0);
    expect(changes).toBe(made.check.gearChanges);
    for (let i = 1; i < directions.length; i++) {
      const [x = 0, y = 0, heading = 0, nextX = 0, nextY = 0] = path.subarray(3 * i - 3, 3 * i + 2);
      const way = (nextX - x) * Math.cos(heading) + (nextY - y) * Math.sin(heading);
      expect(Math.hypot(nextX - x, nextY - y)).toBeGreaterThan(0);
      if (Math.abs(way) > 1e-6) expect(Math.sign(way)).toBe(directions[i - 1]);
    }
  });
});
