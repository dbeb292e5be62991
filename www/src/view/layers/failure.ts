/** The first place at which a planned car hits something, and the depth of the overlap. */
import { failureOf } from "../failure";
import type { Frame, Shown } from "../frame";
import { fixed } from "../text";
import { drawHatchedPose } from "./collisions";
import { drawDimension } from "./dimension";
import { drawPlace } from "./obstruction";

/** Dimensions shorter than this (px) are left to a closer look. */
const LEAST = 8;

export function drawFailure(frame: Frame, { plan, ghost }: Shown): void {
  const failure = plan && !ghost ? failureOf(frame.state.scene, plan) : null;
  if (!failure) return;
  const { overlap } = failure;
  if (overlap && overlap.depth * frame.view.camera.scale >= LEAST) {
    drawHatchedPose(frame, overlap.pose);
    drawDimension(frame, overlap.from, overlap.to, `${fixed(overlap.depth, 2)} m`);
  }
  drawPlace(frame, failure.at);
}
