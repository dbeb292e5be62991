// @ts-check
// `parkade check`.
import { checkPath, sceneGeometry } from "../node.js";
import { choice, isMap, json, scene as read, text } from "./input.js";
import { toJSON, write } from "./output.js";
import { Refused } from "./refusal.js";

/** @type {import("./commands.js").Run} */
export async function check([place, path, ...more], values) {
  const format = choice("format", values.format, ["text", "json"]);
  if (more.length > 0) throw new Refused(`one path at a time, got also ${more.join(", ")}`);
  const scene = await read(place === undefined ? [] : [place]);
  if (path === undefined) {
    const { boundary, slots, vehicle } = sceneGeometry(scene);
    const facts = {
      obstacles: scene.obstacles?.length ?? 0,
      slots: slots.length,
      corners: boundary.length,
      minTurningRadius: vehicle.minTurningRadius,
    };
    // Maps of other programs have no car of their own, and ROS maps no start.
    const blocked = isMap(place) ? [] : overlaps(scene),
      words = blocked.map(
        ({ end, obstacle }) =>
          `${end}-blocked: ${
            obstacle === undefined
              ? "no slot of the goal is free, or the car does not fit into its region"
              : `the car overlaps ${obstacle} at the ${end}`
          }`,
      );
    if (words.length === 0)
      words.push(
        `ok: ${facts.obstacles} obstacles, ${facts.slots} slots, a car that turns ` +
          `in ${facts.minTurningRadius.toFixed(2)} m`,
      );
    await write(format === "json" ? toJSON({ ...facts, blocked }, 2) : `${words.join("\n")}\n`);
    return blocked.length > 0 ? 1 : 0;
  }
  const { poses, directions } = await pathFrom(path);
  const found = checkPath(scene, poses, directions);
  await write(format === "json" ? toJSON(found, 2) : `${sentence(found)}\n`);
  return found.verdict === "ok" ? 0 : 1;
}

/** The ends of the scene at which its car has no place. @param {import("../index.js").Scenario} scene */
function overlaps(scene) {
  const { start, goal, goals } = sceneGeometry(scene);
  const hit = (/** @type {import("../index.js").Pose} */ { x, y, heading }) =>
    checkPath(scene, [x, y, heading]).firstHit?.obstacle;
  const blocked = hit(start) === undefined ? [] : [{ end: "start", obstacle: hit(start) }];
  // Of several goals, one with room is enough.
  const poses = goals?.map(({ pose }) => pose) ?? [goal];
  if (poses.some((pose) => hit(pose) === undefined)) return blocked;
  return [...blocked, { end: "goal", obstacle: poses[0] && hit(poses[0]) }];
}

/** @param {import("../index.js").Check} found */
function sentence({ verdict, hits, firstHit, tightTurns, slips, goalDistance, minTurningRadius }) {
  const words = [
    hits > 0 &&
      `overlaps at ${hits} poses, first ${firstHit?.obstacle} at x ${firstHit?.pose.x.toFixed(
        2,
      )} m, y ${firstHit?.pose.y.toFixed(2)} m`,
    tightTurns > 0 && `${tightTurns} turns tighter than ${minTurningRadius.toFixed(2)} m`,
    slips > 0 && `${slips} steps sideways`,
    `ends ${goalDistance.toFixed(3)} m from the goal`,
  ];
  return `${verdict}: ${words.filter(Boolean).join("; ")}`;
}

/** @param {string} file @returns {Promise<{ poses: number[], directions: number[] | undefined }>} */
async function pathFrom(file) {
  const content = await text(file);
  if (/^\s*[{[]/.test(content)) {
    const value = json(file, content);
    if (!Array.isArray(value?.path)) throw new Refused(`${file}: path: must be a list of x, y, heading, …`);
    return { poses: value.path, directions: value.directions };
  }
  const [head = "", ...rows] = content.trim().split(/\r?\n/);
  const names = head.split(",").map((name) => name.trim());
  const column = (/** @type {string} */ name) => names.indexOf(name);
  for (const name of ["x", "y", "theta"]) if (column(name) < 0) throw new Refused(`${file}:1: has no column ${name}`);
  const cells = rows.map((row) => row.split(","));
  const number = (/** @type {string[]} */ row, /** @type {string} */ name, /** @type {number} */ i) => {
    const cell = row[column(name)],
      value = Number(cell);
    if (!cell?.trim() || !Number.isFinite(value))
      throw new Refused(`${file}:${i + 2}: ${name}: must be a number, got ${JSON.stringify(cell ?? "")}`);
    return value;
  };
  return {
    poses: cells.flatMap((row, i) => ["x", "y", "theta"].map((name) => number(row, name, i))),
    directions: column("direction") < 0 ? undefined : cells.map((row, i) => number(row, "direction", i)),
  };
}
