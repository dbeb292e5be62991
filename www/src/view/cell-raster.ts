/** The cells of one obstacle of a huge map: as bytes, as pictures of one pixel a cell, and as edges tile by tile. */
import type { MapFrame } from "parkade";
import { firstOfRow, type Run } from "../scene/cells";
import { screenToWorld } from "./camera";
import { toScreen, type Frame } from "./frame";
import { context2d, newCanvas } from "./surface";
import { parseColour } from "./tokens";

/** Cells to a side of the squares whose edges are one path. */
export const TILE = 16;
const MOST_TILES = 2000;
/** Rows painted at once; more would hold up the page. */
const BAND = 128;

/** Cells as bytes, row-major from the south, and what has been drawn of them. */
export class Raster {
  readonly taken: Uint8Array;
  private runs: readonly Run[] = [];
  private readonly sheets = new Map<string, RasterLevels>();
  private readonly tiles = new Map<number, Path2D>();

  constructor(readonly map: MapFrame) {
    this.taken = new Uint8Array(map.width * map.height);
  }

  /** Takes over the rows that differ from what is known. */
  update(runs: readonly Run[]): void {
    const before = this.runs;
    if (runs === before) return;
    let head = 0,
      tail = 0;
    const most = Math.min(runs.length, before.length);
    while (head < most && runs[head] === before[head]) head++;
    while (tail < most - head && runs[runs.length - 1 - tail] === before[before.length - 1 - tail]) tail++;
    const changed = [runs[head], before[head], runs[runs.length - 1 - tail], before[before.length - 1 - tail]];
    const rows = changed.flatMap((run) => (run ? [run[1]] : []));
    this.runs = runs;
    this.fill(Math.max(0, Math.min(...rows)), Math.min(this.map.height - 1, Math.max(...rows)));
  }

  sheet(colour: string): RasterLevels {
    let sheet = this.sheets.get(colour);
    if (!sheet) {
      sheet = this.blank(colour);
      sheet.paint(this.taken, 0, this.map.height - 1);
    }
    return sheet;
  }

  /** Paints everything a few rows at a time. */
  async prepare(runs: readonly Run[], colours: readonly string[]): Promise<void> {
    const { height } = this.map;
    for (let row = 0; row < height; row += BAND) {
      this.take(runs, row, Math.min(height, row + BAND) - 1);
      await pause();
    }
    this.runs = runs;
    for (const colour of colours) {
      const sheet = this.blank(colour);
      for (let row = 0; row < height; row += BAND) {
        sheet.paint(this.taken, row, Math.min(height, row + BAND) - 1);
        await pause();
      }
    }
  }

  private blank(colour: string): RasterLevels {
    if (this.sheets.size > 3) this.sheets.clear();
    const sheet = new RasterLevels(this.map.width, this.map.height, colour);
    this.sheets.set(colour, sheet);
    return sheet;
  }

  /** Edges between taken and free cells of a square of cells, in metres. */
  edges(column: number, row: number): Path2D {
    const key = row * 4096 + column;
    let path = this.tiles.get(key);
    if (!path) {
      if (this.tiles.size > MOST_TILES) this.tiles.clear();
      path = this.trace(column * TILE, row * TILE);
      this.tiles.set(key, path);
    }
    return path;
  }

  private fill(first: number, last: number): void {
    this.take(this.runs, first, last);
    this.tiles.clear();
    for (const sheet of this.sheets.values()) sheet.paint(this.taken, first, last);
  }

  private take(runs: readonly Run[], first: number, last: number): void {
    const {
      taken,
      map: { width },
    } = this;
    taken.fill(0, first * width, (last + 1) * width);
    for (let i = firstOfRow(runs, first); i < runs.length; i++) {
      const [x, y, count] = runs[i]!;
      if (y > last) break;
      for (let cell = y * width + x, end = cell + count; cell < end; cell++) taken[cell] = 1;
    }
  }

  private trace(left: number, bottom: number): Path2D {
    const {
      origin: [x0, y0],
      resolution,
      width,
      height,
    } = this.map;
    const path = new Path2D();
    const at = (x: number, y: number): number =>
      x < 0 || y < 0 || x >= width || y >= height ? 0 : this.taken[y * width + x]!;
    const line = (ax: number, ay: number, bx: number, by: number): void => {
      path.moveTo(x0 + ax * resolution, y0 + ay * resolution);
      path.lineTo(x0 + bx * resolution, y0 + by * resolution);
    };
    for (let i = 0; i <= TILE; i++) {
      let across = -1,
        up = -1;
      for (let k = 0; k <= TILE; k++) {
        const inside = k < TILE;
        const flat = inside && at(left + k, bottom + i) !== at(left + k, bottom + i - 1);
        const steep = inside && at(left + i, bottom + k) !== at(left + i - 1, bottom + k);
        if (flat && across < 0) across = k;
        if (!flat && across >= 0) {
          line(left + across, bottom + i, left + k, bottom + i);
          across = -1;
        }
        if (steep && up < 0) up = k;
        if (!steep && up >= 0) {
          line(left + i, bottom + up, left + i, bottom + k);
          up = -1;
        }
      }
    }
    return path;
  }
}

/** A raster in one colour at halving sizes, north at the top. */
class RasterLevels {
  private readonly levels: CanvasRenderingContext2D[] = [];
  private readonly word: number;

  constructor(
    readonly width: number,
    readonly height: number,
    colour: string,
  ) {
    const [r, g, b] = parseColour(colour) ?? [128, 128, 128];
    this.word = ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
    for (let w = width, h = height; ; w = Math.ceil(w / 2), h = Math.ceil(h / 2)) {
      this.levels.push(context2d(newCanvas(w, h)));
      if (Math.max(w, h) <= 64) break;
    }
  }

  /** Paints rows, counted from the south, and the smaller copies of them. */
  paint(taken: ArrayLike<number>, first: number, last: number): void {
    const { width, height, levels } = this;
    const image = levels[0]!.createImageData(width, last - first + 1),
      words = new Uint32Array(image.data.buffer);
    for (let row = first, to = (last - first) * width; row <= last; row++, to -= width) {
      for (let x = 0, from = row * width; x < width; x++, from++) if (taken[from]) words[to + x] = this.word;
    }
    levels[0]!.putImageData(image, 0, height - 1 - last);
    let top = height - 1 - last,
      end = height - first;
    for (let i = 1; i < levels.length; i++) {
      const source = levels[i - 1]!.canvas,
        target = levels[i]!;
      top = Math.floor(top / 2);
      end = Math.min(target.canvas.height, Math.ceil(end / 2));
      target.clearRect(0, top, target.canvas.width, end - top);
      target.drawImage(
        source,
        0,
        2 * top,
        2 * target.canvas.width,
        2 * (end - top),
        0,
        top,
        target.canvas.width,
        end - top,
      );
    }
  }

  /** Draws the part in view on a canvas that is set to CSS pixels. */
  draw(frame: Frame, ctx: CanvasRenderingContext2D, map: MapFrame): void {
    const { view, ratio } = frame;
    const cell = map.resolution * view.camera.scale * ratio;
    const at = cell >= 1 ? 0 : Math.min(this.levels.length - 1, Math.floor(-Math.log2(cell)));
    const { canvas } = this.levels[at]!,
      side = map.resolution * 2 ** at;
    const west = map.origin[0],
      north = map.origin[1] + map.height * map.resolution;
    const [left, top] = screenToWorld(view, 0, 0),
      [right, bottom] = screenToWorld(view, view.width, view.height);
    const x0 = Math.max(0, Math.floor((left - west) / side)),
      x1 = Math.min(canvas.width, Math.ceil((right - west) / side));
    const y0 = Math.max(0, Math.floor((north - top) / side)),
      y1 = Math.min(canvas.height, Math.ceil((north - bottom) / side));
    if (x1 <= x0 || y1 <= y0) return;
    const [dx, dy] = toScreen(frame, [west + x0 * side, north - y0 * side]),
      scale = side * view.camera.scale;
    ctx.imageSmoothingEnabled = cell < 1;
    ctx.drawImage(canvas, x0, y0, x1 - x0, y1 - y0, dx, dy, (x1 - x0) * scale, (y1 - y0) * scale);
  }
}

const pause = (): Promise<void> => new Promise((done) => setTimeout(done));
