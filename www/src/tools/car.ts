/** Parked cars: a click places one, a drag aims it, the wheel turns it. */
import type { Pose } from "parkade";
import { addObstacle } from "../scene/model";
import { distance, radians, towards, wrapAngle, type Point } from "../scene/plane";
import { poseAround, vehicleOf } from "../scene/vehicle";
import { snapAngle } from "./snap";
import { metresOf, type Bench, type Input, type Tool } from "./tool";

const AIM_PX = 14;

export class CarTool implements Tool {
  private heading = 0;
  private placed: Point | null = null;

  cursor(): string {
    return "none";
  }

  hover(bench: Bench, input: Input | null): void {
    if (input && input.touch) return;
    this.show(bench, input ? input.at : null);
  }

  down(bench: Bench, input: Input): void {
    this.placed = input.at;
    this.show(bench, input.at);
  }

  move(bench: Bench, input: Input): void {
    if (!this.placed) return;
    if (distance(this.placed, input.at) > metresOf(bench, AIM_PX)) {
      this.heading = snapAngle(towards(this.placed, input.at), input.alt ? "free" : input.shift ? "always" : "near");
    }
    this.show(bench, this.placed);
  }

  up(bench: Bench): void {
    const { placed } = this;
    this.placed = null;
    bench.show(null);
    if (!placed) return;
    const { carProfile } = bench.store.state.toolOptions;
    const { scene, id } = addObstacle(bench.store.state.scene, { type: "car", pose: this.pose(bench, placed), vehicle: carProfile });
    bench.commit(scene, "car");
    bench.store.set({ selection: { kind: "obstacle", id } });
    bench.done();
  }

  cancel(bench: Bench): boolean {
    const placing = this.placed !== null;
    this.placed = null;
    bench.show(null);
    return placing;
  }

  wheel(bench: Bench, input: Input, notches: number): boolean {
    if (input.ctrl) return false;
    this.heading = wrapAngle(this.heading + radians(input.shift ? 1 : 5) * notches);
    this.show(bench, this.placed ?? input.at);
    return true;
  }

  private pose(bench: Bench, at: Point): Pose {
    return poseAround(at, this.heading, vehicleOf(bench.store.state.toolOptions.carProfile));
  }

  private show(bench: Bench, at: Point | null): void {
    bench.show(at && { preview: { kind: "car", pose: this.pose(bench, at), vehicle: bench.store.state.toolOptions.carProfile } });
  }
}
