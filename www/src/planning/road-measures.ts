/** Figures and collision risk of plans on roads, measured beside the planners. */
import type { collisionRisk, Plan, RoadFigures, Scenario } from "parkade";
import { forPlanners } from "../scene/large-scene";
import type { Scene } from "../store";
import { Helper } from "./job-client";
import type { Engine } from "./engine-loader";

export type Risk = ReturnType<typeof collisionRisk>;

const TRIALS = 1000,
  SLICES = 10;

/** One worker, started when it is first needed. */
export class RoadMeasures {
  private helper: Helper | null = null;

  constructor(private readonly engine: Engine) {}

  figures(scene: Scene, plan: Plan): Promise<RoadFigures> {
    return this.worker().call("roadFigures", { scene: this.packed(scene), path: plan.path });
  }

  /** Tells after every slice; the last one has all trials. Rejects where it is stopped. */
  async risk(scene: Scene, plan: Plan, told: (risk: Risk, of: number) => void): Promise<void> {
    const worker = this.worker(),
      sum = { trials: 0, hits: 0, discHits: 0 };
    for (let k = 0; k < SLICES; k++) {
      const slice = await worker.call("risk", {
        scene: this.packed(scene),
        path: plan.path,
        from: sum.trials,
        trials: TRIALS / SLICES,
      });
      sum.trials += slice.trials;
      sum.hits += slice.hits;
      sum.discHits += slice.discHits;
      told({ ...sum }, TRIALS);
    }
  }

  stop(): void {
    this.helper?.stop();
    this.helper = null;
  }

  private worker(): Helper {
    return (this.helper ??= new Helper(this.engine));
  }

  private packed(scene: Scene): Scenario {
    return forPlanners(scene, this.engine.api.packRuns);
  }
}
