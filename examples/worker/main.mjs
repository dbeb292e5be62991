// Plans beside the main thread: `node main.mjs`. In a browser the same, with `new Worker(url, { type: "module" })`.
import { Worker } from "node:worker_threads";

const worker = new Worker(new URL("worker.mjs", import.meta.url));
const scenes = ["perpendicular", "parallel", "angled"];
let open = scenes.length;
worker.on("message", ({ id, outcome, length, poses }) => {
  console.log(`${id}: ${outcome}, ${length.toFixed(2)} m, ${poses.length / 3} poses`);
  if (--open === 0) void worker.terminate();
});
for (const id of scenes) worker.postMessage(id);
