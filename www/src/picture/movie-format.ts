/** What a movie is, whatever encodes it. */
export const FORMATS = ["gif", "webm", "mp4"] as const;
export type Format = (typeof FORMATS)[number];
/** Formats of video. */
export type Container = Exclude<Format, "gif">;

export interface Movie {
  format: Format;
  /** CSS pixels, even numbers: video needs them. */
  width: number;
  height: number;
  frames: number;
  /** Frames a second. */
  rate: number;
  /** Draws frame `i` on the canvas. */
  draw(canvas: HTMLCanvasElement, i: number): void;
}
