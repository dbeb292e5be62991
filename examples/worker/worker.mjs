// Answers scene ids with plans; the poses move to the other thread, they are not copied.
import { parentPort } from "node:worker_threads";
import { Planner, init, scenario } from "parkade";

const ready = init();
parentPort.on("message", async (id) => {
  await ready;
  const planner = new Planner("hybrid", scenario(id));
  const { outcome, metrics, path } = planner.plan();
  planner.free();
  parentPort.postMessage({ id, outcome, length: metrics.length, poses: path }, [path.buffer]);
});
