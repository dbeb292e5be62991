import type { SearchTrace } from "parkade";
import { STEP, type SearchReplay } from "../../planning/search-replay";
import { inPixels, toScreen, type Frame } from "../frame";
import { RAMP_SIZE, RAMP_WORDS } from "../ramp";
import { context2d, newCanvas } from "../surface";
import { useFont } from "../text";
import { screenToWorld } from "../camera";
import { fade, parseColour } from "../tokens";
import { drawMark } from "./search-marks";
import { nth } from "../../scene/nth";

/** Least sides of a cell, CSS pixels, for outlines, parents, f alone, and g and h beside it. */
const OUTLINED = 5,
  PARENTS = 14,
  ONLY_F = 22,
  ALL_COSTS = 34;

interface Picture {
  canvas: HTMLCanvasElement;
  ctx: CanvasRenderingContext2D;
  image: ImageData;
  words: Uint32Array;
  at: number;
}

/** Draws one replay; keeps the picture of its closed cells between frames. */
export class SearchStepsLayer {
  private picture: Picture | null = null;
  /** Per side and node the step that expanded it. */
  private readonly order: Int32Array[];

  constructor(
    private readonly replay: SearchReplay,
    private readonly trace: SearchTrace,
  ) {
    const { sides } = replay;
    this.order = sides.map(({ entry }) => new Int32Array(entry.length));
    trace.nodes.forEach((node, step) => {
      nth(this.order, replay.sideOf(step))[node] = step;
    });
  }

  draw(frame: Frame): void {
    const { map } = frame.state.scene,
      { trace } = this;
    if (trace.width !== map.width || trace.height !== map.height) return;
    const size = map.resolution * frame.view.camera.scale;
    this.drawClosed(frame, size);
    const visible = this.visible(frame);
    if (size >= OUTLINED) for (const node of visible) this.drawNode(frame, node, size);
    this.drawMoves(frame, size);
  }

  /** Closed cells by their order; open ones too, where they are too small for outlines. */
  private drawClosed(frame: Frame, size: number): void {
    const picture = this.paint(frame, size < OUTLINED);
    const { origin, height, width, resolution } = frame.state.scene.map;
    const [left, top] = toScreen(frame, [origin[0], origin[1] + height * resolution]);
    const { ctx } = frame;
    inPixels(frame);
    ctx.save();
    ctx.imageSmoothingEnabled = false;
    ctx.globalAlpha = 0.42;
    ctx.drawImage(picture.canvas, left, top, width * size, height * size);
    ctx.restore();
  }

  private paint(frame: Frame, withOpen: boolean): Picture {
    const { sides, at, steps } = this.replay,
      { trace } = this;
    const { width, height } = trace;
    const picture = (this.picture ??= blank(width, height));
    const stamp = at * 2 + Number(withOpen);
    if (picture.at === stamp) return picture;
    picture.at = stamp;
    const { words } = picture,
      perStep = RAMP_SIZE / Math.max(1, steps),
      accent = wordOf(frame.tokens.colour.accent),
      back = wordOf(frame.tokens.colour.warn);
    words.fill(0);
    sides.forEach(({ entry, closed }, side) => {
      for (let node = 0; node < entry.length; node++) {
        if (entry[node] === 0) continue;
        const x = node % width,
          place = (height - 1 - (node - x) / width) * width + x;
        if (closed[node])
          words[place] = side === 1 ? back : nth(RAMP_WORDS, (nth(nth(this.order, side), node) * perStep) | 0);
        else if (withOpen) words[place] = accent;
      }
    });
    picture.ctx.putImageData(picture.image, 0, 0);
    return picture;
  }

  /** Nodes that a side has reached, in sight. */
  private visible(frame: Frame): number[] {
    const { map } = frame.state.scene,
      { width, height } = this.trace;
    const [left, top] = screenToWorld(frame.view, 0, 0),
      [right, bottom] = screenToWorld(frame.view, frame.view.width, frame.view.height);
    const column = (x: number): number => Math.floor((x - map.origin[0]) / map.resolution),
      row = (y: number): number => Math.floor((y - map.origin[1]) / map.resolution);
    const nodes: number[] = [];
    for (let y = Math.max(0, row(bottom)); y <= Math.min(height - 1, row(top)); y++)
      for (let x = Math.max(0, column(left)); x <= Math.min(width - 1, column(right)); x++)
        if (this.replay.sides.some(({ entry }) => (entry[y * width + x] ?? 0) > 0)) nodes.push(y * width + x);
    return nodes;
  }

  private middle(frame: Frame, node: number): readonly [number, number] {
    const { origin, resolution } = frame.state.scene.map,
      { width } = this.trace;
    const x = node % width,
      y = (node - x) / width;
    return toScreen(frame, [origin[0] + (x + 0.5) * resolution, origin[1] + (y + 0.5) * resolution]);
  }

  private drawNode(frame: Frame, node: number, size: number): void {
    const {
      ctx,
      tokens: { colour },
    } = frame;
    const [x, y] = this.middle(frame, node);
    this.replay.sides.forEach((_, side) => {
      const known = this.replay.known(side, node);
      if (!known) return;
      if (!known.closed) {
        ctx.strokeStyle = side === 1 ? colour.warn : colour.accent;
        ctx.lineWidth = 1.5;
        ctx.strokeRect(x - size / 2 + 1.5, y - size / 2 + 1.5, size - 3, size - 3);
      }
      if (size >= PARENTS && known.parent >= 0) this.drawParent(frame, [x, y], known.parent, size);
      if (side === 0 || !this.replay.known(0, node)) this.drawCosts(frame, [x, y], size, known);
    });
  }

  private drawParent(frame: Frame, [x, y]: readonly [number, number], parent: number, size: number): void {
    const { ctx, tokens } = frame;
    const [px, py] = this.middle(frame, parent),
      far = Math.hypot(px - x, py - y) || 1;
    const dx = (px - x) / far,
      dy = (py - y) / far,
      from = size * 0.36,
      to = size * 0.52;
    ctx.strokeStyle = tokens.colour.t3;
    ctx.lineWidth = 1;
    ctx.beginPath();
    ctx.moveTo(x + dx * from, y + dy * from);
    ctx.lineTo(x + dx * to, y + dy * to);
    const head = Math.min(4, size * 0.12);
    ctx.moveTo(x + dx * to - head * (dx - dy), y + dy * to - head * (dy + dx));
    ctx.lineTo(x + dx * to, y + dy * to);
    ctx.lineTo(x + dx * to - head * (dx + dy), y + dy * to - head * (dy - dx));
    ctx.stroke();
  }

  private drawCosts(
    frame: Frame,
    [x, y]: readonly [number, number],
    size: number,
    known: { f: number; g: number; h: number },
  ): void {
    if (size < ONLY_F) return;
    const {
      ctx,
      tokens: { colour, font },
    } = frame;
    const digits = size >= 80 ? 2 : size >= 52 ? 1 : 0;
    const text = (value: number): string => (value / this.trace.unit).toFixed(digits);
    ctx.textBaseline = "middle";
    ctx.textAlign = "center";
    // Numbers stand on a ramp from dark to light: a halo keeps them legible.
    ctx.strokeStyle = colour.floor;
    ctx.fillStyle = colour.t1;
    ctx.lineWidth = 3;
    ctx.lineJoin = "round";
    const put = (what: string, left: number, top: number): void => {
      ctx.strokeText(what, left, top);
      ctx.fillText(what, left, top);
    };
    useFont(ctx, `600 ${size >= ALL_COSTS ? 12 : 11}px ${font}`);
    put(text(known.g + known.h), x, size >= ALL_COSTS ? y + size * 0.12 : y);
    if (size < ALL_COSTS) return;
    useFont(ctx, `400 ${size >= 64 ? 12 : 10}px ${font}`);
    ctx.textAlign = "left";
    put(text(known.g), x - size / 2 + 3, y - size / 2 + 8);
    ctx.textAlign = "right";
    put(text(known.h), x + size / 2 - 3, y - size / 2 + 8);
  }

  /** The node at hand, and what has become of its moves so far. */
  private drawMoves(frame: Frame, size: number): void {
    const { step, move } = this.replay,
      { trace } = this;
    if (step < 0) return;
    const {
      ctx,
      tokens: { colour },
    } = frame;
    inPixels(frame);
    const isCandidate = this.replay.kindOf(step) === STEP.candidate;
    let [x, y] = this.middle(frame, nth(trace.nodes, step));
    const here = [x, y] as const,
      half = Math.max(3, size / 2 - 1);
    for (let one = nth(trace.first, step); one <= move; one++) {
      const target = nth(trace.targets, one);
      if (target === trace.nodes[step]) continue;
      const at = this.middle(frame, target);
      if (isCandidate || Math.hypot(at[0] - x, at[1] - y) > size * 1.6) {
        ctx.strokeStyle = fade(isCandidate && this.replay.fateOf(one) === "blocked" ? colour.err : colour.accent, 0.7);
        ctx.lineWidth = 1.5;
        ctx.setLineDash([4, 3]);
        ctx.beginPath();
        ctx.moveTo(x, y);
        ctx.lineTo(at[0], at[1]);
        ctx.stroke();
        ctx.setLineDash([]);
      }
      const corner = size >= ALL_COSTS ? size * 0.3 : 0;
      drawMark(
        frame,
        this.replay.fateOf(one),
        at[0] + corner,
        at[1] + corner,
        Math.min(7, Math.max(3, size * 0.24)),
        one === move,
      );
      // A candidate's legs follow one another.
      if (isCandidate) [x, y] = at;
    }
    [x, y] = here;
    ctx.strokeStyle = colour.floor;
    ctx.lineWidth = 5;
    ctx.strokeRect(x - half, y - half, 2 * half, 2 * half);
    ctx.strokeStyle = colour.t1;
    ctx.lineWidth = 2.5;
    ctx.strokeRect(x - half, y - half, 2 * half, 2 * half);
  }
}

/** A colour as images keep it. */
function wordOf(colour: string): number {
  const [r, g, b] = parseColour(colour) ?? [128, 128, 128];
  return ((255 << 24) | (b << 16) | (g << 8) | r) >>> 0;
}

function blank(width: number, height: number): Picture {
  const canvas = newCanvas(width, height);
  const ctx = context2d(canvas);
  const image = ctx.createImageData(width, height);
  return { canvas, ctx, image, words: new Uint32Array(image.data.buffer), at: -1 };
}
