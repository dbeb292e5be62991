/** The way of one manoeuvre as a table. */
import type { Plan } from "parkade";
import { markedPoses } from "../picture/site-drawing";
import { poseAt } from "../view/drive";
import { nth } from "../scene/nth";

/** The marked poses of a way, with the clearance of the body at each. */
export function wayCsv(plan: Plan, every: number): string {
  const poses = Array.from({ length: plan.path.length / 3 }, (_, i) => poseAt(plan, i)),
    along = [0];
  for (let i = 1; i < poses.length; i++)
    along.push(
      nth(along, i - 1) + Math.hypot(nth(poses, i).x - nth(poses, i - 1).x, nth(poses, i).y - nth(poses, i - 1).y),
    );
  const rows = markedPoses(poses, every).map((i) => {
    const { x, y, heading } = nth(poses, i),
      clearance = plan.clearances[i];
    return (
      [nth(along, i), x, y, heading].map((value) => value.toFixed(4)).join(",") +
      `,${typeof clearance === "number" ? clearance.toFixed(3) : ""}`
    );
  });
  return ["distance_m,x_m,y_m,heading_rad,clearance_m", ...rows, ""].join("\r\n");
}
