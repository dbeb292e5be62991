/** Parked cars: a click places one, a drag aims it, the wheel turns it. Cones are placed likewise. */
import type { Pose } from "parkade";
import { addObstacle, nextId, type Scene } from "../scene/model";
import { distance, radians, towards, wrapAngle, type Point } from "../scene/geometry";
import { poseAround, vehicleOf } from "../scene/vehicle";
import { snapAngle } from "./snap";
import { metresOf, type ToolContext, type Input, type Tool } from "./tool";

const AIM_PX = 14;
/** Half of a cone's foot, metres. */
const CONE = 0.2;

export class CarTool implements Tool {
  private heading = 0;
  private placed: Point | null = null;

  cursor(): string {
    return "none";
  }

  hover(context: ToolContext, input: Input | null): void {
    if (input?.touch) return;
    this.show(context, input ? input.at : null);
  }

  down(context: ToolContext, input: Input): void {
    this.placed = input.at;
    this.show(context, input.at);
  }

  move(context: ToolContext, input: Input): void {
    if (!this.placed) return;
    if (distance(this.placed, input.at) > metresOf(context, AIM_PX)) {
      this.heading = snapAngle(towards(this.placed, input.at), input.alt ? "free" : input.shift ? "always" : "near");
    }
    this.show(context, this.placed);
  }

  up(context: ToolContext): void {
    const { placed } = this;
    this.placed = null;
    context.show(null);
    if (!placed) return;
    const { carProfile } = context.store.state.toolOptions;
    const { scene, id } =
      carProfile === "cone"
        ? addCone(context.store.state.scene, placed)
        : addObstacle(context.store.state.scene, {
            type: "car",
            pose: this.pose(placed, carProfile),
            vehicle: carProfile,
          });
    context.commit(scene, carProfile === "cone" ? "cone" : "car");
    context.store.set({ selection: { kind: "obstacle", id } });
    context.done();
  }

  cancel(context: ToolContext): boolean {
    const placing = this.placed !== null;
    this.placed = null;
    context.show(null);
    return placing;
  }

  wheel(context: ToolContext, input: Input, notches: number): boolean {
    if (input.ctrl) return false;
    this.heading = wrapAngle(this.heading + radians(input.shift ? 1 : 5) * notches);
    this.show(context, this.placed ?? input.at);
    return true;
  }

  private pose(at: Point, profile: "paper" | "sedan"): Pose {
    return poseAround(at, this.heading, vehicleOf(profile));
  }

  private show(context: ToolContext, at: Point | null): void {
    const { carProfile } = context.store.state.toolOptions;
    if (!at) context.show(null);
    else if (carProfile === "cone") context.show({ preview: { kind: "brush", at, radius: CONE, erase: false } });
    else context.show({ preview: { kind: "car", pose: this.pose(at, carProfile), vehicle: carProfile } });
  }
}

/** An octagon of a cone's foot. */
function addCone(scene: Scene, [x, y]: Point): { scene: Scene; id: string } {
  const id = nextId(scene, "cone"),
    round = (value: number): number => Math.round(value * 1000) / 1000;
  const points = Array.from(
    { length: 8 },
    (_, k): Point => [round(x + CONE * Math.cos((k * Math.PI) / 4)), round(y + CONE * Math.sin((k * Math.PI) / 4))],
  );
  return { scene: { ...scene, obstacles: [...(scene.obstacles ?? []), { type: "polygon", id, points }] }, id };
}
