/** Box of the last drawn pose label: a click on it asks for numbers. */
import type { Box, Point } from "../scene/geometry";

export type PoseLabel = "start" | "goal";

const labels = new WeakMap<HTMLElement, { which: PoseLabel; box: Box }>();

export function keepPoseLabel(canvas: HTMLElement, which: PoseLabel | null, box?: Box): void {
  if (which && box) labels.set(canvas, { which, box });
  else labels.delete(canvas);
}

export function poseLabelAt(canvas: HTMLElement | null, [x, y]: Point): PoseLabel | null {
  const label = canvas && labels.get(canvas);
  const inside = label && x >= label.box.minX && x <= label.box.maxX && y >= label.box.minY && y <= label.box.maxY;
  return inside ? label.which : null;
}

/** Event that the canvas receives; its host opens a field there. */
export interface PoseRequest {
  which: PoseLabel;
  box: Box;
}

/** False where no label of this pose is shown. */
export function askForPose(canvas: HTMLElement | null, which: PoseLabel): boolean {
  const label = canvas && labels.get(canvas);
  if (!label || label.which !== which) return false;
  canvas.dispatchEvent(new CustomEvent<PoseRequest>("parkade-pose", { detail: label }));
  return true;
}
