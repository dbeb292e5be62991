/** Outlines as the browser's `Path2D` takes them, written as an SVG path's data in pixels. */
import { nth } from "../scene/nth";

export type Matrix = readonly [number, number, number, number, number, number];
/** In its own units; an arc has its middle, radius, angles and 1 where it turns back. */
type Step = readonly ["M" | "L" | "Q" | "C" | "Z" | "A", ...number[]];

export class Path2D {
  readonly steps: Step[] = [];
  moveTo(x: number, y: number): void {
    this.steps.push(["M", x, y]);
  }
  lineTo(x: number, y: number): void {
    this.steps.push(["L", x, y]);
  }
  quadraticCurveTo(...at: number[]): void {
    this.steps.push(["Q", ...at]);
  }
  bezierCurveTo(...at: number[]): void {
    this.steps.push(["C", ...at]);
  }
  closePath(): void {
    this.steps.push(["Z"]);
  }
  addPath(other: Path2D): void {
    for (const step of other.steps) this.steps.push(step);
  }
  arc(x: number, y: number, radius: number, from: number, to: number, back = false): void {
    this.steps.push(["A", x, y, radius, from, to, back ? 1 : 0]);
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.steps.push(["M", x, y], ["L", x + width, y], ["L", x + width, y + height], ["L", x, y + height], ["Z"]);
  }

  roundRect(x: number, y: number, width: number, height: number, r: number): void {
    this.moveTo(x + r, y);
    [
      [x + width - r, y + r],
      [x + width - r, y + height - r],
      [x + r, y + height - r],
      [x + r, y + r],
    ].forEach(([cx, cy], i) => {
      this.arc(cx!, cy!, r, ((i - 1) * Math.PI) / 2, (i * Math.PI) / 2);
    });
    this.closePath();
  }
}

export const times = ([a, b, c, d, e, f]: Matrix, [g, h, i, j, k, l]: Matrix): Matrix => [
  a * g + c * h,
  b * g + d * h,
  a * i + c * j,
  b * i + d * j,
  a * k + c * l + e,
  b * k + d * l + f,
];

export const apply = ([a, b, c, d, e, f]: Matrix, x: number, y: number): [number, number] => [
  a * x + c * y + e,
  b * x + d * y + f,
];

/** Pixels of a unit; the drawing scales both axes alike. */
export const scaleOf = ([a, b]: Matrix): number => Math.hypot(a, b);

/** A hundredth of a pixel is finer than any screen. */
export const n = (value: number, digits = 2): string => String(Number(value.toFixed(digits)) || 0);

/** Steps, each as it stands under its transform. */
export class Outline {
  text = "";

  add(steps: readonly Step[], matrix: Matrix): void {
    for (const [kind, ...at] of steps) {
      if (kind === "A") this.addArc(at as [number, number, number, number, number, number], matrix);
      else this.addPoints(kind === "L" && !this.text ? "M" : kind, at, matrix);
    }
  }

  private addPoints(kind: string, at: readonly number[], matrix: Matrix): void {
    const points = [];
    for (let i = 0; i < at.length; i += 2)
      points.push(
        apply(matrix, nth(at, i), nth(at, i + 1))
          .map((value) => n(value))
          .join(" "),
      );
    this.text += kind + points.join(" ");
  }

  private addArc(
    [x, y, radius, from, to, back]: [number, number, number, number, number, number],
    matrix: Matrix,
  ): void {
    const full = 2 * Math.PI,
      all = Math.abs(to - from) >= full;
    const turn = all
      ? back
        ? -full
        : full
      : back
        ? -((((from - to) % full) + full) % full)
        : (((to - from) % full) + full) % full;
    const mirrored = matrix[0] * matrix[3] < matrix[1] * matrix[2],
      r = n(radius * scaleOf(matrix));
    this.addPoints(this.text ? "L" : "M", [x + radius * Math.cos(from), y + radius * Math.sin(from)], matrix);
    // An arc's flags cannot tell a circle, or half of one, from nothing.
    const parts = Math.ceil(Math.abs(turn) / 3);
    for (let i = 1; i <= parts; i++) {
      const angle = from + (turn * i) / parts;
      const end = apply(matrix, x + radius * Math.cos(angle), y + radius * Math.sin(angle))
        .map((value) => n(value))
        .join(" ");
      this.text += `A${r} ${r} 0 0 ${turn < 0 === mirrored ? 1 : 0} ${end}`;
    }
  }
}
