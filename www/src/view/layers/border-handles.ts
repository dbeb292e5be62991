/** The handles of the ground's sides, and its size while one is dragged. */
import { axisOf, groundOf, sizeAlong } from "../../scene/ground";
import { mapOutline } from "../../scene/model";
import type { Draft } from "../../store/draft";
import { HANDLE_PX, handlesOn, type BorderHandle } from "../border-handles";
import { inMetres, inPixels, pixels, polygonPath, type Frame } from "../frame";
import { drawPill, fixed, PILL_HEIGHT, pillWidth } from "../text";

/** On the map that the pointer is on. */
export function drawBorderHandles(frame: Frame, { scene, hot, drags, canvas }: NonNullable<Draft["border"]>): void {
  const {
    ctx,
    state,
    view,
    tokens: { colour },
  } = frame;
  if (drags && scene !== state.scene) {
    inMetres(frame);
    ctx.strokeStyle = colour.accent;
    ctx.lineWidth = pixels(frame, 1.5);
    ctx.stroke(polygonPath(mapOutline(scene)));
  }
  if (ctx.canvas !== canvas) return;
  for (const handle of handlesOn(scene, view)) {
    drawHandle(frame, handle, handle.side === hot);
    if (drags && handle.side === hot) drawSize(frame, handle, sizeText(sizeAlong(groundOf(scene), axisOf(hot))));
  }
}

function drawHandle({ ctx, ratio, tokens: { colour } }: Frame, { at: [x, y] }: BorderHandle, isHot: boolean): void {
  inPixels({ ctx, ratio });
  const left = Math.round(x - HANDLE_PX / 2) + 0.5,
    top = Math.round(y - HANDLE_PX / 2) + 0.5;
  ctx.fillStyle = isHot ? colour.accent : colour.floor;
  ctx.fillRect(left, top, HANDLE_PX - 1, HANDLE_PX - 1);
  ctx.lineWidth = 1.5;
  ctx.strokeStyle = isHot ? colour.accent : colour["obs-edge"];
  ctx.strokeRect(left, top, HANDLE_PX - 1, HANDLE_PX - 1);
}

/** Inside the border, off the pointer. */
function drawSize(frame: Frame, { side, at: [x, y] }: BorderHandle, text: string): void {
  const width = pillWidth(frame, text),
    gap = 16,
    { view } = frame;
  const left = side === "right" ? x - width - gap : side === "left" ? x + gap : x - width / 2;
  const top = side === "top" ? y + gap : side === "bottom" ? y - PILL_HEIGHT - gap : y - PILL_HEIGHT / 2;
  drawPill(
    frame,
    text,
    Math.min(Math.max(4, left), view.width - width - 4),
    Math.min(Math.max(4, top), view.height - PILL_HEIGHT - 4),
    "solid",
  );
}

const sizeText = (metres: number): string =>
  `${fixed(metres, Math.abs(metres * 10 - Math.round(metres * 10)) < 1e-4 ? 1 : 2)} m`;
