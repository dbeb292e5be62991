/** The page's scenes: their things have names, by which edits find them. */
import type {
  CostArea as GivenCostArea,
  MovingObstacle as GivenMovingObstacle,
  Obstacle as GivenObstacle,
  Road as GivenRoad,
  Scenario as GivenScenario,
  Slot as GivenSlot,
} from "parkade";

/** Those of a scene from outside may lack names. */
export type { GivenObstacle, GivenScenario, GivenSlot };

type Named<Thing> = Thing extends unknown ? Thing & { id: string } : never;
export type CostArea = Named<GivenCostArea>;
export type MovingObstacle = Named<GivenMovingObstacle>;
export type Obstacle = Named<GivenObstacle>;
export type Road = Named<GivenRoad>;
export type Slot = Named<GivenSlot>;

export interface Scenario extends GivenScenario {
  obstacles?: Obstacle[];
  slots?: Slot[];
  costs?: CostArea[];
  moving?: MovingObstacle[];
}
