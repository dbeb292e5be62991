/** Start or target by press, drag, release: the press sets the rear axle, the drag the heading. */
import type { Pose } from "parkade";
import { movePose, resolve } from "../scene/model";
import { distance, towards, type Point } from "../scene/geometry";
import { snapAngle } from "./snap";
import { metresOf, type Bench, type Input, type Tool } from "./tool";

const AIM_PX = 8;

export class PlaceTool implements Tool {
  readonly drags = true;
  private at: Point | null = null;

  constructor(private readonly which: "start" | "goal") {}

  cursor(): string {
    return "crosshair";
  }

  hover(bench: Bench, input: Input | null): void {
    bench.show(input ? { preview: { kind: "pose", which: this.which, pose: this.pose(bench, input.at, null) } } : null);
  }

  down(bench: Bench, input: Input): void {
    this.at = input.at;
    bench.store.set({ selection: { kind: this.which } });
    this.move(bench, input);
  }

  move(bench: Bench, input: Input): void {
    if (!this.at) return;
    const aimed = distance(this.at, input.at) > metresOf(bench, AIM_PX);
    bench.show({ grabbed: { which: this.which, part: "grip" } });
    bench.preview(movePose(bench.store.state.scene, this.which, this.pose(bench, this.at, aimed ? input : null)));
  }

  up(bench: Bench): void {
    if (!this.at) return;
    this.at = null;
    bench.show(null);
    bench.commit(bench.store.state.scene, this.which);
  }

  cancel(bench: Bench): boolean {
    const placing = this.at !== null;
    this.at = null;
    bench.show(null);
    if (placing) bench.revert();
    return placing;
  }

  private pose(bench: Bench, at: Point, aim: Input | null): Pose {
    const before = resolve(bench.store.state.scene)[this.which];
    const heading = aim ? snapAngle(towards(at, aim.at), aim.alt ? "free" : "near") : before.heading;
    return { x: at[0], y: at[1], heading };
  }
}
