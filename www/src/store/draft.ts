/** The preview of a tool before its result joins the scene. World metres and radians. */
import type { Selection } from "../scene/selection";
import type { Pose, Slot, VehicleSpec } from "parkade";
import type { Point } from "../scene/geometry";
import type { Side } from "../scene/ground";
import type { Scenario } from "../scene/scenario";

export type Preview =
  | { kind: "brush"; at: Point; radius: number; erase: boolean; label?: string }
  | {
      kind: "line";
      points: Point[];
      cursor: Point | null;
      thickness: number;
      closing: boolean;
      refused: boolean;
      closed: boolean;
    }
  | { kind: "rectangle"; center: Point; size: Point; heading: number; from: Point; to: Point }
  | { kind: "car"; pose: Pose; vehicle: VehicleSpec }
  | { kind: "marquee"; from: Point; to: Point }
  | { kind: "slots"; slots: Omit<Slot, "id">[]; from: Point; to: Point; aisle: Aisle }
  | { kind: "pose"; which: "start" | "goal"; pose: Pose };

/** The lane in front of a row of slots; `free` falls short of `width` where something stands in it. Metres. */
export interface Aisle {
  from: Point;
  to: Point;
  width: number;
  free: number;
}

/** A dotted line through two points that says what something lines up with. */
export interface Guide {
  from: Point;
  to: Point;
}

export interface Draft {
  preview?: Preview;
  guides?: Guide[];
  /** Size or length of what is being drawn; beside `at`. */
  label?: { text: string; at: Point };
  /** The object under the pointer. */
  hot?: Selection;
  /** The pose being dragged: its label is shown as edited. */
  grabbed?: { which: "start" | "goal"; part: "body" | "grip" };
  /** The handles of this scene's ground on a map; the one under the pointer, and whether it is being dragged. */
  border?: { scene: Scenario; hot: Side | null; drags: boolean; canvas: HTMLElement | null };
}
