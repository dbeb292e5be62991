/** Huge maps as pictures of one pixel a cell, smaller copies of them for smaller scales, and edges only close up. */
import type { Layer, MapFrame, Obstacle, Plan } from "parkade";
import type { Point } from "../scene/geometry";
import type { Scenario } from "../scene/scenario";
import { MANY } from "../scene/large-scene";
import { screenToWorld } from "./camera";
import { Raster, TILE } from "./cell-raster";
import { GHOST, inMetres, inPixels, pixels, toScreen, type Frame, type Shown } from "./frame";
import { hatchPattern } from "./hatch";
import { RAMP_SIZE, RAMP_WORDS } from "./ramp";
import { hullsAlong, type Convex } from "./swept";
import { fade, mix, plannerStyle, type Tokens } from "./tokens";

type CellsObstacle = Extract<Obstacle, { type: "cells" }>;

/** Pixels a cell from which edges are drawn. */
const EDGES_FROM = 6;

const rasters = new WeakMap<MapFrame, Map<string, Raster>>();

function rasterOf(map: MapFrame, id: string): Raster {
  const known = rasters.get(map) ?? new Map<string, Raster>();
  rasters.set(map, known);
  const raster = known.get(id) ?? new Raster(map);
  known.set(id, raster);
  return raster;
}

/** Far off, where edges would cover everything, cells are darker instead. */
const farColour = ({ colour }: Tokens): string => mix(colour["obs-edge"], colour.obs, 0.4);

/** Makes a scene's pictures before its first frame. */
export async function prepare({ map, obstacles = [] }: Scenario, tokens: Tokens): Promise<void> {
  for (const one of obstacles) {
    if (one.type === "cells" && one.runs.length > MANY)
      await rasterOf(map, one.id ?? "").prepare(one.runs, [farColour(tokens), tokens.colour.obs]);
  }
}

/** Draws very many cells. */
export function drawCells(frame: Frame, { id = "", runs }: CellsObstacle): true {
  const {
    ctx,
    view,
    tokens,
    state: {
      scene: { map },
    },
  } = frame;
  const raster = rasterOf(map, id);
  raster.update(runs);
  const near = map.resolution * view.camera.scale >= EDGES_FROM;
  inPixels(frame);
  raster.sheet(near ? tokens.colour.obs : farColour(tokens)).draw(frame, ctx, map);
  if (near) strokeEdges(frame, raster);
  return true;
}

function strokeEdges(frame: Frame, raster: Raster): void {
  const {
      ctx,
      view,
      tokens: { colour },
    } = frame,
    { origin, resolution, width, height } = raster.map;
  const [left, top] = screenToWorld(view, 0, 0),
    [right, bottom] = screenToWorld(view, view.width, view.height);
  const tile = (metres: number): number => Math.floor(metres / resolution / TILE);
  inMetres(frame);
  ctx.strokeStyle = colour["obs-edge"];
  ctx.lineWidth = pixels(frame, 1.25);
  ctx.lineCap = "square";
  for (
    let row = Math.max(0, tile(bottom - origin[1]));
    row <= Math.min(tile((height - 1) * resolution), tile(top - origin[1]));
    row++
  ) {
    for (
      let column = Math.max(0, tile(left - origin[0]));
      column <= Math.min(tile((width - 1) * resolution), tile(right - origin[0]));
      column++
    ) {
      ctx.stroke(raster.edges(column, row));
    }
  }
  ctx.lineCap = "butt";
}

const scratch = document.createElement("canvas");

/**
 * The part of a raster in view, one pixel a cell, or a screen's pixel where cells are smaller; `word` is a cell's
 * colour.
 */
function drawSampled(frame: Frame, pen: CanvasRenderingContext2D, word: (cell: number) => number): void {
  const {
    view,
    state: {
      scene: { map },
    },
  } = frame;
  const { width, height, resolution, origin } = map;
  const [left, top] = screenToWorld(view, 0, 0),
    [right, bottom] = screenToWorld(view, view.width, view.height);
  const step = Math.max(1, Math.ceil(1 / (resolution * view.camera.scale)));
  const first = (metres: number): number => Math.max(0, Math.floor(metres / resolution / step));
  const x0 = first(left - origin[0]),
    y0 = first(bottom - origin[1]);
  const x1 = Math.min(Math.ceil(width / step), first(right - origin[0]) + 1),
    y1 = Math.min(Math.ceil(height / step), first(top - origin[1]) + 1);
  if (x1 <= x0 || y1 <= y0) return;
  const image = new ImageData(x1 - x0, y1 - y0),
    words = new Uint32Array(image.data.buffer);
  for (let y = y0, to = (y1 - 1 - y0) * (x1 - x0); y < y1; y++, to -= x1 - x0) {
    for (let x = x0, from = y * step * width + x0 * step; x < x1; x++, from += step) words[to + x - x0] = word(from);
  }
  scratch.width = x1 - x0;
  scratch.height = y1 - y0;
  scratch.getContext("2d")?.putImageData(image, 0, 0);
  const side = step * resolution,
    [dx, dy] = toScreen(frame, [origin[0] + x0 * side, origin[1] + y1 * side]),
    scale = side * view.camera.scale;
  pen.imageSmoothingEnabled = false;
  pen.drawImage(scratch, dx, dy, (x1 - x0) * scale, (y1 - y0) * scale);
}

const stencil = document.createElement("canvas");

/** Hatches the cells of a raster that hold one of these values. */
export function drawKinds(frame: Frame, { data }: Layer, values: readonly number[], colour: string, every = 5): true {
  const { ctx, view, ratio } = frame;
  const pen = stencil.getContext("2d");
  if (!pen) return true;
  stencil.width = ctx.canvas.width;
  stencil.height = ctx.canvas.height;
  inPixels({ ctx: pen, ratio });
  const wanted = new Uint32Array(256);
  for (const value of values) wanted[value] = 0xff000000;
  drawSampled(frame, pen, (cell) => wanted[data[cell]!]!);
  pen.globalCompositeOperation = "source-in";
  pen.fillStyle = hatchPattern({ ...frame, ctx: pen }, colour, every, 1);
  pen.fillRect(0, 0, view.width, view.height);
  inPixels(frame);
  ctx.drawImage(stencil, 0, 0, view.width, view.height);
  return true;
}

/**
 * In the raster `redundant`: where a disc as wide as the car would touch something, and free, but closed by the search.
 */
const NECESSARY = 2,
  REDUNDANT = 3;

/**
 * The space that a grid planner closes before it searches: the necessary one hatched densely, the redundant one widely.
 */
export function drawClosed(frame: Frame, closed: Layer): void {
  drawKinds(frame, closed, [NECESSARY], fade(frame.tokens.colour.t1, 0.38), 3.5);
  drawKinds(frame, closed, [REDUNDANT], fade(frame.tokens.colour.t1, 0.24), 7);
}

const ranks = new WeakMap<Uint32Array, Int32Array>();

/** The order of expansion on a huge map. */
export function drawHeat(frame: Frame, cells: Uint32Array, count: number): true {
  const {
    ctx,
    state: {
      scene: { map },
    },
  } = frame;
  let rank = ranks.get(cells);
  if (!rank) {
    rank = new Int32Array(map.width * map.height);
    for (let i = cells.length - 1; i >= 0; i--) rank[cells[i]!] = i + 1;
    ranks.set(cells, rank);
  }
  const known = rank,
    part = RAMP_SIZE / Math.max(1, cells.length);
  inPixels(frame);
  ctx.save();
  ctx.globalAlpha = frame.tokens.dark ? 0.46 : 0.5;
  drawSampled(frame, ctx, (cell) => {
    const at = known[cell]!;
    return at > 0 && at <= count ? RAMP_WORDS[((at - 1) * part) | 0]! : 0;
  });
  ctx.restore();
  return true;
}

const hulls = new WeakMap<Plan, Convex[]>();
/** Pixels a metre below which a car is a line. */
const FAR = 4;

/** The swept area of a path of kilometres: what is in view of it, without an outline. */
export function drawLongSweep(frame: Frame, { plan, planner, ghost }: Shown): true {
  if (!plan) return true;
  const {
    ctx,
    view,
    resolved: { vehicle },
  } = frame;
  ctx.save();
  inMetres(frame);
  ctx.globalAlpha = 0.15 * (ghost ? GHOST : 1);
  ctx.fillStyle = ctx.strokeStyle = plannerStyle(frame.tokens, planner).colour;
  ctx.beginPath();
  if (view.camera.scale < FAR) {
    const step = 3 * Math.max(1, Math.floor(5 / view.camera.scale));
    for (let i = 0; i + 2 < plan.path.length; i += step) ctx.lineTo(plan.path[i]!, plan.path[i + 1]!);
    ctx.lineWidth = vehicle.width;
    ctx.stroke();
  } else {
    const known = hulls.get(plan) ?? hullsAlong(plan, vehicle);
    hulls.set(plan, known);
    const [left, top] = screenToWorld(view, 0, 0),
      [right, bottom] = screenToWorld(view, view.width, view.height);
    for (const { corners, box } of known) {
      if (box.minX > right || box.maxX < left || box.minY > top || box.maxY < bottom) continue;
      corners.forEach(([x, y]: Point, i) => (i === 0 ? ctx.moveTo(x, y) : ctx.lineTo(x, y)));
      ctx.closePath();
    }
    ctx.fill();
  }
  ctx.restore();
  return true;
}
