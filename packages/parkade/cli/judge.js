// @ts-check
// `parkade judge`.
import { ParkadeError, judge as verdict } from "../node.js";
import { choice, json, numerics, scene as read, text } from "./input.js";
import { toJSON, write } from "./output.js";
import { Refused, byOption } from "./refusal.js";

/** Options that are limits, and their names in the API. */
const LIMITS = {
  speed: "speed",
  acceleration: "acceleration",
  deceleration: "deceleration",
  "steering-rate": "steeringRate",
};

/** @type {import("./commands.js").Run} */
export async function judge([place, file, ...more], values) {
  const format = choice("format", values.format, ["text", "json"]);
  if (file === undefined) throw new Refused("which trajectory? `parkade judge SCENE TRAJECTORY`, CSV or JSON");
  if (more.length > 0) throw new Refused(`one trajectory at a time, got also ${more.join(", ")}`);
  const scene = await read(place === undefined ? [] : [place]);
  const content = await text(file);
  const found = byOption(LIMITS, () => verdictOn(scene, file, content, numerics(LIMITS, values)));
  await write(format === "json" ? toJSON(found, 2) : `${lines(found).join("\n")}\n`);
  return found.passes ? 0 : 1;
}

/**
 * @param {import("../index.js").Scenario} scene
 * @param {string} file
 * @param {string} content
 * @param {import("../index.js").MotionLimits} limits
 */
function verdictOn(scene, file, content, limits) {
  const trajectory = /^\s*[{[]/.test(content) ? json(file, content) : content;
  try {
    return verdict(scene, trajectory, limits);
  } catch (error) {
    if (!(error instanceof ParkadeError)) throw error;
    if (error.code === "bad-import") throw new Refused(`${file}:${error.message}`);
    if (error.code === "bad-input") throw new Refused(`${file}: ${error.message.replace(/^trajectory[.:] ?/, "")}`);
    throw error;
  }
}

/** @param {import("../index.js").Judgement} found */
function lines(found) {
  const { touchingFrames, frames, uncertified, firstContact, endError, modelError } = found;
  const degrees = (/** @type {number} */ angle) => `${((angle * 180) / Math.PI).toFixed(2)}°`;
  return [
    `${found.passes ? "passes" : "fails"}: goal ${
      found.attained ? "attained" : "not attained"
    }, limits ${found.keepsLimits ? "kept" : "not kept"}`,
    `ends ${(endError.x * 1000).toFixed(1)} mm, ${(endError.y * 1000).toFixed(
      1,
    )} mm and ${degrees(endError.heading)} from the goal, at ${found.endSpeed.toFixed(3)} m/s`,
    `poses differ from the car's motion ` +
      `by ${(modelError.distance * 1000).toFixed(1)} mm and ${degrees(modelError.heading)}`,
    `${touchingFrames} of ${frames} frames touch${
      firstContact === null ? "" : `, first ${firstContact.obstacle} after ${firstContact.t.toFixed(3)} s`
    }; ${uncertified} stretches between frames not certified; least clearance ${found.minClearance.toFixed(3)} m`,
    `duration ${found.duration.toFixed(3)} s, length ${found.length.toFixed(2)} m, gear changes ${found.gearChanges}`,
    `effort ${found.effort.toFixed(3)}, steering ${found.steeringEffort.toFixed(
      3,
    )}, smoothness ${found.smoothness.toFixed(2)}, TPCAP cost ${found.tpcapCost.toFixed(1)}`,
    `at most ${found.maxSpeed.toFixed(3)} m/s, +${found.maxAcceleration.toFixed(
      3,
    )} and -${found.maxDeceleration.toFixed(
      3,
    )} m/s², ${found.maxSteering.toFixed(4)} rad, ${found.maxSteeringRate.toFixed(4)} rad/s`,
  ];
}
