/** Start or target by press, drag, release: the press sets the rear axle, the drag the heading. */
import type { Pose } from "parkade";
import { movePose, resolve } from "../scene/model";
import { distance, towards, type Point } from "../scene/geometry";
import { snapAngle } from "./snap";
import { metresOf, type ToolContext, type Input, type Tool } from "./tool";

const AIM_PX = 8;

export class PlaceTool implements Tool {
  readonly drags = true;
  private at: Point | null = null;

  constructor(private readonly which: "start" | "goal") {}

  cursor(): string {
    return "crosshair";
  }

  hover(context: ToolContext, input: Input | null): void {
    context.show(
      input ? { preview: { kind: "pose", which: this.which, pose: this.pose(context, input.at, null) } } : null,
    );
  }

  down(context: ToolContext, input: Input): void {
    this.at = input.at;
    context.store.set({ selection: { kind: this.which } });
    this.move(context, input);
  }

  move(context: ToolContext, input: Input): void {
    if (!this.at) return;
    const aimed = distance(this.at, input.at) > metresOf(context, AIM_PX);
    context.show({ grabbed: { which: this.which, part: "grip" } });
    context.preview(movePose(context.store.state.scene, this.which, this.pose(context, this.at, aimed ? input : null)));
  }

  up(context: ToolContext): void {
    if (!this.at) return;
    this.at = null;
    context.show(null);
    context.commit(context.store.state.scene, this.which);
  }

  cancel(context: ToolContext): boolean {
    const placing = this.at !== null;
    this.at = null;
    context.show(null);
    if (placing) context.revert();
    return placing;
  }

  private pose(context: ToolContext, at: Point, aim: Input | null): Pose {
    const before = resolve(context.store.state.scene)[this.which];
    const heading = aim ? snapAngle(towards(at, aim.at), aim.alt ? "free" : "near") : before.heading;
    return { x: at[0], y: at[1], heading };
  }
}
