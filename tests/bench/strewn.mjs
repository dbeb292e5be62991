// Plans the random scenes that come in, one a line, in WebAssembly; fails where an answer differs from the native one.
//
//   cargo xtask build && cargo run --release --example strew lines 1000 | node tests/bench/strewn.mjs
import { createInterface } from "node:readline";
import { init, Planner } from "../../pkg/node.js";

await init();
let count = 0;
const different = [];
for await (const line of createInterface({ input: process.stdin })) {
  const { seed, scene, config, hash } = JSON.parse(line);
  const planner = new Planner("hybrid", scene, config);
  if (planner.plan().hash !== hash) different.push(seed);
  planner.free();
  count++;
}
console.log(`${count} scenes, ${different.length} different${different.length > 0 ? `: seeds ${different.join(", ")}` : ""}`);
process.exitCode = count > 0 && different.length === 0 ? 0 : 1;
