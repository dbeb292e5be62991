// `cargo xtask paper road`: the road manuscript's tables measured through the built package, as JSON.
//
// Usage: node road.mjs [ROUNDS] | node road.mjs memory SCENE. Memory is that of a module of its own that plans one
// scene once: all that it has asked for, code, stack, scene and answer included, since wasm gives nothing back.
import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import load from "../../pkg/parkade.js";
import { init, paperRoad, paperRoadRows, Planner, scenario } from "../../pkg/node.js";

const [what = "5", scene = ""] = process.argv.slice(2);
await init();

if (what === "memory") {
  const { memory } = await load();
  const before = memory.buffer.byteLength;
  const planner = new Planner("cost-map", scenario(scene));
  planner.plan();
  console.log(memory.buffer.byteLength - before);
} else {
  const rows = paperRoadRows();
  // The engine compiles what is called often, on threads of its own; that is not to be measured.
  for (const { id } of rows) paperRoad({ row: id, rounds: 2 });
  const tables = rows.map(({ id }) => paperRoad({ row: id, rounds: Number(what) }));
  const node = (...words) =>
    execFileSync(process.execPath, [fileURLToPath(import.meta.url), ...words], { encoding: "utf8" });
  const grown = tables.map(({ row }) => (row.ship ? null : Number(node("memory", row.scene))));
  console.log(JSON.stringify({ tables, grown }));
}
