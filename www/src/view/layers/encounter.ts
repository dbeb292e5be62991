import type { Encounter, Pose } from "parkade";
import "../../i18n/later";
import { translate } from "../../i18n/index";
import { boxAt, clockOf } from "../playback-time";
import { inPixels, toScreen, type Frame } from "../frame";
import { labelFont, useFont } from "../text";
import type { Point } from "../../scene/geometry";
import { lastIn, nth } from "../../scene/nth";

export interface Mark {
  name: "A" | "B" | "C" | "D" | "S" | "W" | "E";
  of: "box" | "car";
  t: number;
  at: Point;
}

/**
 * A: the first box sets off; B: where it is when the car stops; C: when the car drives on; D: where it ends. S, W, E:
 * the car sets off, waits, ends. Empty where nothing is waited for.
 */
export function marksOf(frame: Frame, { waits, path, t }: Encounter): Mark[] {
  const [box] = frame.state.scene.moving ?? [],
    [wait] = waits;
  if (!box || !wait) return [];
  const last = t.length - 1,
    end = endOf(box);
  const point = ({ x, y }: Pose): Point => [x, y];
  const boxes = (
    [
      ["A", box.start ?? 0],
      ["B", wait.from],
      ["C", wait.to],
      ["D", end],
    ] as const
  ).map(([name, at]): Mark => ({ name, of: "box", t: at, at: point(boxAt(box, at)) }));
  return [
    ...boxes,
    { name: "S", of: "car", t: 0, at: [nth(path, 0), nth(path, 1)] },
    { name: "W", of: "car", t: wait.from, at: point(wait.pose) },
    { name: "E", of: "car", t: nth(t, last), at: [nth(path, 3 * last), nth(path, 3 * last + 1)] },
  ];
}

function endOf({ points, speed, start = 0 }: NonNullable<Frame["state"]["scene"]["moving"]>[number]): number {
  let length = 0;
  for (let i = 1; i < points.length; i++)
    length += Math.hypot(nth(points, i)[0] - nth(points, i - 1)[0], nth(points, i)[1] - nth(points, i - 1)[1]);
  return start + length / speed;
}

const RADIUS = 9,
  STRIP = { height: 54, side: 56, row: 18, above: 8 };

export function drawEncounter(frame: Frame, drive: Encounter): void {
  const marks = marksOf(frame, drive);
  if (marks.length === 0) return;
  inPixels(frame);
  for (const mark of marks) badge(frame, mark, toScreen(frame, mark.at));
  if (frame.view.width >= 420 && frame.view.height >= 260) strip(frame, drive, marks);
}

function badge({ ctx, tokens: { colour, font } }: Frame, { name, of }: Mark, [x, y]: Point): void {
  const up = of === "box" ? -16 : 16;
  ctx.beginPath();
  ctx.arc(x, y + up, RADIUS, 0, 2 * Math.PI);
  ctx.fillStyle = of === "box" ? colour["warn-soft"] : colour.panel;
  ctx.fill();
  ctx.strokeStyle = of === "box" ? colour.warn : colour.t1;
  ctx.lineWidth = 1.25;
  ctx.stroke();
  ctx.fillStyle = colour.t1;
  ctx.font = `600 12px ${font}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.fillText(name, x, y + up + 0.5);
  ctx.textAlign = "left";
  ctx.textBaseline = "alphabetic";
}

/** Two lines over one axis of seconds: the box from A to D, the car from S over its waits to E. */
function strip(frame: Frame, { waits, t }: Encounter, marks: readonly Mark[]): void {
  const {
      ctx,
      view,
      tokens: { colour },
      state,
    } = frame,
    { lang } = state;
  const end = Math.max(t.at(-1) ?? 1, ...marks.map((mark) => mark.t)),
    left = STRIP.side,
    right = view.width - 24;
  const top = STRIP.above,
    x = (at: number): number => left + ((right - left) * at) / end;
  ctx.fillStyle = colour.panel;
  ctx.globalAlpha = 0.92;
  ctx.fillRect(8, top, view.width - 16, STRIP.height);
  ctx.globalAlpha = 1;
  useFont(ctx, labelFont(frame));
  const rows = [
    ["box", translate(lang, "encounter.box"), top + STRIP.row],
    ["car", translate(lang, "encounter.car"), top + 2 * STRIP.row],
  ] as const;
  for (const [of, name, y] of rows) {
    const own = marks.filter((mark) => mark.of === of),
      from = nth(own, 0).t,
      to = lastIn(own).t;
    ctx.fillStyle = colour.t2;
    ctx.fillText(name, 16, y + 4);
    line(frame, x(from), x(to), y, of === "box" ? colour.warn : colour.t1, 3);
    if (of === "car") for (const wait of waits) line(frame, x(wait.from), x(wait.to), y, colour.warn, 7);
    for (const mark of own) {
      ctx.fillStyle = colour.t1;
      ctx.fillText(mark.name, x(mark.t) - 4, y - 5);
    }
  }
  ctx.fillStyle = colour.t3;
  const axis = top + STRIP.height - 4,
    every = end > 30 ? 10 : 5;
  for (let s = 0; s <= end; s += every) ctx.fillText(`${s} s`, x(s) - 6, axis);
  const now = x(Math.min(end, clockOf(state)));
  ctx.beginPath();
  ctx.moveTo(now, top + 2);
  ctx.lineTo(now, top + 2 * STRIP.row + 6);
  ctx.strokeStyle = colour.accent;
  ctx.lineWidth = 1.5;
  ctx.stroke();
}

function line({ ctx }: Frame, from: number, to: number, y: number, ink: string, width: number): void {
  ctx.beginPath();
  ctx.moveTo(from, y);
  ctx.lineTo(to, y);
  ctx.strokeStyle = ink;
  ctx.lineWidth = width;
  ctx.stroke();
}
