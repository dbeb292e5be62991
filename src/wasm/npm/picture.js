// @ts-check
// A scene and its plans as an SVG picture; in the complete module only.
import { sceneGeometry, unpackRuns } from "./api.js";
import { ParkadeError, numbers, object, text } from "./runtime.js";

/** @typedef {readonly [number, number]} Point */
/** @typedef {import("./index.js").Pose} Pose */
/** @typedef {import("./index.js").Vehicle} Vehicle */

const LIGHT = { out: "#ECECE9", floor: "#FFFFFF", grid: "#F1F1EE", ink: "#1B1D20", obs: "#B4B8BE", edge: "#3F444B", parked: "#D5D8DC", slot: "#7D838B" };
const DARK = { out: "#0B0D0F", floor: "#15181C", grid: "#1B1F24", ink: "#ECEEF0", obs: "#4C535C", edge: "#A3AAB3", parked: "#343A42", slot: "#858C95" };
/** Colour and dash of a planner, the page's. @type {Record<string, [string, string]>} */
const LINES = { four: ["#0072B2", ""], eight: ["#D55E00", "9 5"], "risk-field": ["#009E73", "10 4 2 4"], hybrid: ["#CC79A7", ""], "hybrid-forward": ["#6A6A6A", "14 5"] };
/** Pixels kept free around what is shown. */
const SPARE = 6;
/** Metres from the nose to the end of the page's handle, and a little more. */
const GRIP = 1.8;
/** Poses between two outlines of the swept body. */
const EVERY = 2;

/** @type {typeof import("./index.js").toSVG} */
export function toSVG(given, plans = [], options = {}) {
  const { width = 720, height = 420, theme = "auto" } = object(options, "options");
  for (const [name, value] of Object.entries({ width, height })) {
    if (typeof value !== "number" || !(value >= 16 && value <= 8192)) throw new ParkadeError(`${name}: must be 16 to 8192 pixels, got ${String(value)}`, "bad-input", name);
  }
  if (!["auto", "light", "dark"].includes(theme)) throw new ParkadeError(`theme: must be auto, light or dark, got ${String(theme)}`, "bad-input", "theme");
  const geometry = sceneGeometry(given), data = JSON.stringify(given, (_, value) => (typeof value === "bigint" ? Number(value) : value));
  /** @type {import("./index.js").Scenario} */
  const scene = JSON.parse(data);
  const title = text(options.title ?? scene.name ?? "", "title");
  const found = (Array.isArray(plans) ? plans : [plans]).filter((plan, i) => object(plan, `plans[${i}]`).outcome === "found");
  found.forEach(checkPlan);
  const lead = found.find((plan) => plan.planner === "hybrid") ?? found[found.length - 1];
  const view = viewOf(geometry, found.filter((plan) => plan.check.drivable), width, height);
  const px = 1 / view.scale;
  const { vehicle } = geometry;
  const parts = [
    polygon(geometry.boundary, `class="pk-border" stroke-width="${n(12 * px)}"`), polygon(geometry.boundary, 'class="pk-floor"'), grid(view, geometry.boundary, width, height),
    ...geometry.slots.map(([a, b, c, d]) => line([a, d, c, b].map(sure), `class="pk-slot" stroke-width="${n(px)}"`)),
    ...(scene.obstacles ?? []).map((obstacle) => solid(obstacle, scene.map, px)),
    ...geometry.parkedCars.map((car) => body(car.pose, car.vehicle, px, 'class="pk-parked"')),
    lead?.check.drivable ? sweep(lead, vehicle) : "",
    body(geometry.goal, vehicle, px, `class="pk-goal" stroke-dasharray="${n(5 * px)} ${n(3.5 * px)}"`), body(geometry.start, vehicle, px, 'class="pk-start"'),
    ...found.filter((plan) => plan !== lead).map((plan) => path(plan, px)), lead ? path(lead, px) : "",
    lead ? body(poseAt(lead.path, lead.path.length / 3 - 1), vehicle, px, `class="pk-start" style="stroke:${styleOf(lead.planner)[0]}"`) : "",
    ...[geometry.start, geometry.goal].map(({ x, y }) => `<circle class="pk-start" cx="${n(x)}" cy="${n(y)}" r="${n(3 * px)}" stroke-width="${n(1.5 * px)}"/>`),
  ];
  const { scale, x, y } = view;
  const move = `matrix(${n(scale)} 0 0 ${n(-scale)} ${n(width / 2 - x * scale)} ${n(height / 2 + y * scale)})`;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img">`
    + `<title>${escaped(title)}</title><metadata>${escaped(data)}</metadata><style>${styles(theme)}</style>`
    + `<rect class="pk-out" width="${width}" height="${height}"/><g transform="${move}">${parts.join("")}</g></svg>\n`;
}

/** What a picture needs of a plan. @param {import("./index.js").Plan} plan */
function checkPlan({ planner, path, check }) {
  text(planner, "plan.planner");
  object(check, "plan.check");
  if (numbers(Float64Array, path, "plan.path").length < 3) throw new ParkadeError("plan.path: must have poses", "bad-input", "plan.path");
}

/** @param {string} theme */
function styles(theme) {
  /** @param {typeof LIGHT} c */
  const rules = (c) =>
    `.pk-out{fill:${c.out}}.pk-floor{fill:${c.floor}}.pk-grid{fill:none;stroke:${c.grid}}.pk-border{fill:none;stroke:${c.edge}}`
    + `.pk-slot{fill:none;stroke:${c.slot}}.pk-obs{fill:${c.obs};stroke:${c.edge};stroke-linejoin:round}.pk-wall{fill:none;stroke:${c.edge}}`
    + `.pk-parked{fill:${c.parked};stroke:${c.edge}}.pk-start{fill:${c.floor};fill-opacity:.7;stroke:${c.ink}}.pk-goal{fill:none;stroke:${c.ink}}.pk-casing{fill:none;stroke:${c.floor};stroke-linejoin:round}`;
  return theme === "dark" ? rules(DARK) : theme === "light" ? rules(LIGHT) : `${rules(LIGHT)}@media (prefers-color-scheme:dark){${rules(DARK)}}`;
}

/**
 * The page's first camera: start, goal and where the car sweeps.
 * @param {import("./index.js").SceneGeometry} geometry
 * @param {readonly import("./index.js").Plan[]} plans
 * @param {number} width
 * @param {number} height
 */
function viewOf({ start, goal, vehicle, boundary }, plans, width, height) {
  const points = [...corners(start, vehicle, 0.6), ...corners(goal, vehicle, 0.6)];
  if (plans.length === 0) {
    const swing = vehicle.minTurningRadius * 0.45;
    points.push(...corners(goal, vehicle, swing), ...corners(start, vehicle, swing / 2));
  }
  for (const plan of plans) for (let i = 0; i < plan.path.length / 3; i += 4) points.push(...corners(poseAt(plan.path, i), vehicle, 0));
  const box = boxOf(points), floor = boxOf(boundary);
  const kept = /** @type {Point[]} */ ([
    [Math.max(box.left, floor.left - 0.5), Math.max(box.bottom, floor.bottom - 0.5)],
    [Math.min(box.right, floor.right + 0.5), Math.min(box.top, floor.top + 0.5)],
    at(goal, vehicle.rearToFront + GRIP, 0),
  ]);
  const { left, right, bottom, top } = boxOf(kept);
  const scale = Math.min(400, (width - 2 * SPARE) / Math.max(1, right - left), (height - 2 * SPARE) / Math.max(1, top - bottom));
  return { x: (left + right) / 2, y: (bottom + top) / 2, scale };
}

/**
 * @param {{ x: number, y: number, scale: number }} view
 * @param {readonly Point[]} boundary
 * @param {number} width
 * @param {number} height
 */
function grid({ x, y, scale }, boundary, width, height) {
  const floor = boxOf(boundary);
  const left = Math.max(floor.left, x - width / 2 / scale), right = Math.min(floor.right, x + width / 2 / scale);
  const bottom = Math.max(floor.bottom, y - height / 2 / scale), top = Math.min(floor.top, y + height / 2 / scale);
  let step = scale > 40 ? 1 : scale > 4 ? 5 : scale > 0.8 ? 25 : 250;
  while (step * scale < 4) step *= 10;
  let d = "";
  for (let at = Math.ceil(left / step) * step; at <= right; at += step) d += `M${n(at)} ${n(bottom)}V${n(top)}`;
  for (let at = Math.ceil(bottom / step) * step; at <= top; at += step) d += `M${n(left)} ${n(at)}H${n(right)}`;
  return `<path class="pk-grid" stroke-width="${n(1 / scale)}" d="${d}"/>`;
}

/**
 * @param {import("./index.js").Obstacle} obstacle
 * @param {import("./index.js").MapFrame} map
 * @param {number} px
 */
function solid(obstacle, map, px) {
  const edge = `class="pk-obs" stroke-width="${n(1.25 * px)}"`;
  switch (obstacle.type) {
    case "polygon": return polygon(obstacle.points, edge);
    case "rectangle": {
      const { center: [x, y], size: [length, width], heading = 0 } = obstacle;
      return polygon([[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a = 0, b = 0]) => at({ x, y, heading }, (a * length) / 2, (b * width) / 2)), edge);
    }
    case "wall": return line(obstacle.points, `class="pk-wall" stroke-width="${n(Math.max(obstacle.thickness ?? 0, 3 * px))}"`);
    case "car": return body(obstacle.pose, vehicleOf(obstacle.vehicle), px, 'class="pk-parked"');
    case "cells": {
      const runs = typeof obstacle.runs === "string" ? unpackRuns(obstacle.runs) : obstacle.runs;
      const { origin: [left, bottom], resolution: r } = map;
      const d = runs.map(([x, y, count]) => `M${n(left + x * r)} ${n(bottom + y * r)}h${n(count * r)}v${n(r)}h${n(-count * r)}z`).join("");
      return `<path class="pk-obs" stroke="none" style="stroke:none" d="${d}"/>`;
    }
  }
}

/** @type {Record<string, Vehicle>} */
const VEHICLES = {
  paper: { wheelbase: 3.7, width: 2.6, rearToFront: 4.5, rearToBack: 1, maxSteer: 0.6 },
  sedan: { wheelbase: 2.8, width: 1.9, rearToFront: 3.75, rearToBack: 0.95, maxSteer: 0.4711 },
  ship: { wheelbase: 36, width: 16, rearToFront: 54, rearToBack: 18, maxSteer: 0.245 },
};

/** @param {import("./index.js").VehicleSpec} [spec] */
const vehicleOf = (spec = "paper") => (typeof spec === "object" ? spec : sure(VEHICLES[spec]));

/**
 * A car: its outline, rounder at the nose, and the windscreen.
 * @param {Pose} pose
 * @param {Vehicle} v
 * @param {number} px
 * @param {string} style
 */
function body(pose, v, px, style) {
  const half = v.width / 2, back = -v.rearToBack, front = v.rearToFront, nose = Math.min(0.62, half * 0.6), tail = Math.min(0.4, half * 0.4);
  const share = (/** @type {number} */ part) => back + part * (front - back);
  const outline = `M${n(back + tail)} ${n(-half)}H${n(front - nose)}Q${n(front)} ${n(-half)} ${n(front)} ${n(-half + nose)}V${n(half - nose)}Q${n(front)} ${n(half)} ${n(front - nose)} ${n(half)}`
    + `H${n(back + tail)}Q${n(back)} ${n(half)} ${n(back)} ${n(half - tail)}V${n(-half + tail)}Q${n(back)} ${n(-half)} ${n(back + tail)} ${n(-half)}Z`;
  const glass = `M${n(share(0.6))} ${n(-half * 0.68)}V${n(half * 0.68)}L${n(share(0.715))} ${n(half * 0.82)}V${n(-half * 0.82)}Z`;
  const degrees = (pose.heading * 180) / Math.PI;
  return `<path ${style} stroke-width="${n(1.5 * px)}" transform="translate(${n(pose.x)} ${n(pose.y)}) rotate(${n(degrees)})" d="${outline}${glass}"/>`;
}

/**
 * What the body covers along the path: every so many outlines, joined by their union in one translucent group.
 * @param {import("./index.js").Plan} plan
 * @param {Vehicle} vehicle
 */
function sweep(plan, vehicle) {
  let d = "";
  const count = plan.path.length / 3;
  for (let i = 0; i < count; i += EVERY) d += `${polygonData(corners(poseAt(plan.path, Math.min(i, count - 1)), vehicle, 0))}`;
  return `<path fill="${styleOf(plan.planner)[0]}" opacity=".15" d="${d}"/>`;
}

/**
 * The planner's line over a casing in the floor's colour.
 * @param {import("./index.js").Plan} plan
 * @param {number} px
 */
function path(plan, px) {
  const [colour, dash] = styleOf(plan.planner);
  const wide = plan.planner.startsWith("hybrid") ? 3 : 2;
  const points = /** @type {Point[]} */ ([]);
  for (let i = 0; i + 2 < plan.path.length; i += 3) points.push([sure(plan.path[i]), sure(plan.path[i + 1])]);
  const dashes = dash ? ` stroke-dasharray="${dash.split(" ").map((part) => n(Number(part) * px)).join(" ")}"` : "";
  return line(points, `class="pk-casing" stroke-width="${n((wide + 2.4) * px)}"`) + line(points, `fill="none" stroke="${colour}" stroke-linejoin="round" stroke-width="${n(wide * px)}"${dashes}`);
}

/** @param {string} planner @returns {[string, string]} */
const styleOf = (planner) => (Object.hasOwn(LINES, planner) ? sure(LINES[planner]) : ["#8C6D00", "4 4"]);

/** @param {Float64Array} path @param {number} i @returns {Pose} */
const poseAt = (path, i) => ({ x: sure(path[3 * i]), y: sure(path[3 * i + 1]), heading: sure(path[3 * i + 2]) });

/** @param {Pose} pose @param {number} ahead @param {number} left @returns {Point} */
function at({ x, y, heading }, ahead, left) {
  const c = Math.cos(heading), s = Math.sin(heading);
  return [x + ahead * c - left * s, y + ahead * s + left * c];
}

/** @param {Pose} pose @param {Vehicle} v @param {number} margin */
function corners(pose, v, margin) {
  const front = v.rearToFront + margin, back = -v.rearToBack - margin, side = v.width / 2 + margin;
  return [at(pose, back, -side), at(pose, front, -side), at(pose, front, side), at(pose, back, side)];
}

/** @param {readonly Point[]} points */
function boxOf(points) {
  const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (const [x, y] of points) {
    box.left = Math.min(box.left, x);
    box.right = Math.max(box.right, x);
    box.bottom = Math.min(box.bottom, y);
    box.top = Math.max(box.top, y);
  }
  return box;
}

/** @param {readonly Point[]} points */
const polygonData = (points) => `M${points.map(([x, y]) => `${n(x)} ${n(y)}`).join("L")}Z`;

/** @param {readonly Point[]} points @param {string} style */
const polygon = (points, style) => `<path ${style} d="${polygonData(points)}"/>`;

/** @param {readonly Point[]} points @param {string} style */
const line = (points, style) => `<path ${style} d="M${points.map(([x, y]) => `${n(x)} ${n(y)}`).join("L")}"/>`;

/** A tenth of a millimetre is finer than any screen. @param {number} value */
const n = (value) => String(Math.round(value * 1e4) / 1e4);

/** @param {string} text */
const escaped = (text) => String(text).replace(/[&<>"\u0000-\u0008\u000b\u000c\u000e-\u001f]/g, (one) => (one < " " ? "" : `&#${one.charCodeAt(0)};`));

/** @template T @param {T | undefined} value @returns {T} */
const sure = (value) => /** @type {T} */ (value);
