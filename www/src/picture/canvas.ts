/** As much of a canvas as the drawing uses; it keeps marks for an SVG file. */
import type { Surface } from "../view/surface";
import { apply, n, Outline, Path2D, scaleOf, times, type Matrix } from "./path";
import { nth } from "../scene/nth";
import { keysOf } from "../scene/records";

/** A shape, a text or a raster: what is fixed, and the style that a theme can change. `markup` is open at its end. */
export interface Mark {
  tag: "path" | "text" | "g";
  markup: string;
  inside: string;
  style: Record<string, string>;
  pattern: Pattern | null;
}
/** A square that repeats: hatching. */
export interface Pattern {
  canvas: Canvas;
  setTransform(): void;
}

type Image = Pick<ImageData, "width" | "height"> & { data: Uint8ClampedArray };

interface Settings {
  matrix: Matrix;
  clipped: string;
  fillStyle: string | Pattern;
  strokeStyle: string;
  lineWidth: number;
  lineCap: string;
  lineJoin: string;
  dash: readonly number[];
  lineDashOffset: number;
  globalAlpha: number;
  font: string;
  textAlign: string;
  textBaseline: string;
}

const FIRST: Settings = {
  matrix: [1, 0, 0, 1, 0, 0],
  clipped: "",
  fillStyle: "#000",
  strokeStyle: "#000",
  lineWidth: 1,
  lineCap: "butt",
  lineJoin: "miter",
  dash: [],
  lineDashOffset: 0,
  globalAlpha: 1,
  font: "12px sans-serif",
  textAlign: "left",
  textBaseline: "alphabetic",
};
const ANCHORS: Record<string, string> = { center: ' text-anchor="middle"', right: ' text-anchor="end"' };
/** About what a digit of a label is wide: nothing measures text in a file. */
const DIGIT = 6.7;

// biome-ignore lint/correctness/noUnusedVariables: it gives the class below its fields
interface Pen extends Settings {}

class Pen {
  readonly marks: Mark[] = [];
  /** Clip paths by their ids. */
  readonly clips = new Map<string, string>();
  image: Image | null = null;
  private readonly kept: Settings[] = [];
  private path = new Outline();

  constructor(readonly canvas: Canvas) {
    Object.assign(this, FIRST);
  }

  save(): void {
    const kept = { ...FIRST };
    for (const key of keysOf(FIRST)) Object.assign(kept, { [key]: this[key] });
    this.kept.push(kept);
  }
  restore(): void {
    Object.assign(this, this.kept.pop());
  }
  setTransform(...matrix: [number, number, number, number, number, number]): void {
    this.matrix = matrix;
  }
  translate(x: number, y: number): void {
    this.matrix = times(this.matrix, [1, 0, 0, 1, x, y]);
  }
  rotate(angle: number): void {
    this.matrix = times(this.matrix, [Math.cos(angle), Math.sin(angle), -Math.sin(angle), Math.cos(angle), 0, 0]);
  }
  setLineDash(dash: readonly number[]): void {
    this.dash = [...dash];
  }

  beginPath(): void {
    this.path = new Outline();
  }
  moveTo(x: number, y: number): void {
    this.path.add([["M", x, y]], this.matrix);
  }
  lineTo(x: number, y: number): void {
    this.path.add([["L", x, y]], this.matrix);
  }
  closePath(): void {
    this.path.add([["Z"]], this.matrix);
  }
  arc(...at: Parameters<Path2D["arc"]>): void {
    this.add((path) => path.arc(...at));
  }
  roundRect(...at: Parameters<Path2D["roundRect"]>): void {
    this.add((path) => path.roundRect(...at));
  }

  fill(path?: Path2D): void {
    const { fillStyle } = this,
      plain = typeof fillStyle === "string";
    this.mark("path", ` d="${this.data(path)}"`, "", plain ? paint("fill", fillStyle) : {}, plain ? null : fillStyle);
  }

  stroke(path?: Path2D): void {
    const size = scaleOf(this.matrix),
      dashed = this.dash.some((part) => part > 0);
    const dash = dashed ? ` stroke-dasharray="${this.dash.map((part) => n(part * size)).join(" ")}"` : "";
    const shift = dashed && this.lineDashOffset ? ` stroke-dashoffset="${n(this.lineDashOffset * size)}"` : "";
    const cap = this.lineCap === "butt" ? "" : ` stroke-linecap="${this.lineCap}"`;
    const join = this.lineJoin === "miter" ? ' stroke-miterlimit="10"' : ` stroke-linejoin="${this.lineJoin}"`;
    this.mark(
      "path",
      ` d="${this.data(path)}" stroke-width="${n(this.lineWidth * size)}"${cap}${join}${dash}${shift}`,
      "",
      { fill: "none", ...paint("stroke", this.strokeStyle) },
    );
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    this.fill(rectangle(x, y, width, height));
  }
  strokeRect(x: number, y: number, width: number, height: number): void {
    this.stroke(rectangle(x, y, width, height));
  }

  clip(path: Path2D, rule = "nonzero"): void {
    const text = `${this.clipping()}><path d="${this.data(path)}"${
      rule === "evenodd" ? ' clip-rule="evenodd"' : ""
    }/></clipPath>`;
    this.clipped = nameOf(text);
    this.clips.set(this.clipped, `<clipPath id="${this.clipped}"${text}`);
  }

  fillText(text: string, x: number, y: number): void {
    const [px, py] = apply(this.matrix, x, y),
      middle = this.textBaseline === "middle" ? ' dominant-baseline="central"' : "";
    this.mark("text", ` x="${n(px)}" y="${n(py)}"${ANCHORS[this.textAlign] ?? ""}${middle}`, escaped(text), {
      font: this.font,
      ...paint("fill", String(this.fillStyle)),
    });
  }

  measureText(text: string): { width: number } {
    return { width: text.length * DIGIT };
  }
  createPattern(canvas: Canvas): Pattern {
    return { canvas, setTransform: () => undefined };
  }
  createImageData(width: number, height: number): Image {
    return { width, height, data: new Uint8ClampedArray(4 * width * height) };
  }
  putImageData(image: Image): void {
    this.image = image;
  }

  /** Cells as strokes along their rows, by colour. */
  drawImage({ pen: { image } }: Canvas, x: number, y: number, width: number, height: number): void {
    if (!image) return;
    const words = new Uint32Array(image.data.buffer),
      rows = new Map<number, string>(),
      wide = image.width;
    for (let at = 0, end = 0; at < words.length; at = end) {
      const column = at % wide,
        word = nth(words, at);
      for (end = at + 1; end % wide > 0 && words[end] === word; end++);
      if (word >>> 24) rows.set(word, `${rows.get(word) ?? ""}M${column} ${(at - column) / wide + 0.5}h${end - at}`);
    }
    const [left, top] = apply(this.matrix, x, y),
      size = scaleOf(this.matrix);
    const fit = `matrix(${n((width * size) / wide, 6)} 0 0 ${n(
      (height * size) / image.height,
      6,
    )} ${n(left)} ${n(top)})`;
    const lines = [...rows].map(
      ([word, d]) => `<path stroke="${hexOf([word & 255, (word >>> 8) & 255, (word >>> 16) & 255])}" d="${d}"/>`,
    );
    this.mark("g", "", `<g shape-rendering="crispEdges" transform="${fit}">${lines.join("")}</g>`, {});
  }

  private add(make: (path: Path2D) => void): void {
    const path = new Path2D();
    make(path);
    this.path.add(path.steps, this.matrix);
  }

  private data(path?: Path2D): string {
    if (!path) return this.path.text;
    const outline = new Outline();
    outline.add(path.steps, this.matrix);
    return outline.text;
  }

  private clipping(): string {
    return this.clipped && ` clip-path="url(#${this.clipped})"`;
  }

  private mark(
    tag: Mark["tag"],
    markup: string,
    inside: string,
    style: Mark["style"],
    pattern: Pattern | null = null,
  ): void {
    const opacity: Mark["style"] = this.globalAlpha < 1 ? { opacity: n(this.globalAlpha, 3) } : {};
    this.marks.push({ tag, markup: markup + this.clipping(), inside, style: { ...style, ...opacity }, pattern });
  }
}

function rectangle(x: number, y: number, width: number, height: number): Path2D {
  const path = new Path2D();
  path.rect(x, y, width, height);
  return path;
}

export class Canvas {
  width = 0;
  height = 0;
  readonly pen = new Pen(this);
  getContext(): Pen {
    return this.pen;
  }
}

/** Drawings on it become marks. */
export const file: Surface = {
  path: () => new Path2D() as unknown as globalThis.Path2D,
  canvas: (width, height) => Object.assign(new Canvas(), { width, height }) as unknown as HTMLCanvasElement,
};

const hexOf = (parts: readonly number[]): string =>
  `#${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`;

/** Readers of SVG other than browsers know no alpha within a colour. */
function paint(what: "fill" | "stroke", colour: string): Mark["style"] {
  const parts = /^rgba?\((\d+)[ ,]+(\d+)[ ,]+(\d+)(?:[ ,/]+([\d.]+))?\)$/.exec(colour);
  if (!parts) return { [what]: colour };
  const alpha: Mark["style"] = parts[4] ? { [`${what}-opacity`]: n(Number(parts[4]), 3) } : {};
  return { [what]: hexOf([Number(parts[1]), Number(parts[2]), Number(parts[3])]), ...alpha };
}

/** The same for the same text, so that pictures in one file may share what they name. */
export function nameOf(text: string): string {
  let a = 0x811c9dc5,
    b = 5381;
  for (let i = 0; i < text.length; i++) {
    a = Math.imul(a ^ text.charCodeAt(i), 0x01000193);
    b = (Math.imul(b, 33) + text.charCodeAt(i)) | 0;
  }
  return `k${(a >>> 0).toString(36)}${(b >>> 0).toString(36)}`;
}

/** Without the characters that no XML may hold. */
export const escaped = (text: string): string =>
  text.replace(/[&<>"\u0000-\u0008\u000b\u000c\u000e-\u001f]/g, (one) => (one < " " ? "" : `&#${one.charCodeAt(0)};`));
