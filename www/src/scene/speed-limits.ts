/** How fast cars are driven: on roads they need not creep. */
import type { Limits } from "parkade";
import type { GivenScenario } from "./scenario";

const ROAD: Limits = { speed: 10, acceleration: 1.5, deceleration: 2, lateralAcceleration: 2, jerk: 2 };

export const hasRoad = ({ lanes, obstacles }: Pick<GivenScenario, "lanes" | "obstacles">): boolean =>
  Boolean(lanes?.length) || (obstacles ?? []).some(({ type }) => type === "road");

export const limitsOn = (scene: Pick<GivenScenario, "lanes" | "obstacles">): Limits => (hasRoad(scene) ? ROAD : {});
/** Metres a second at which drive times are reckoned without a trajectory. */
export const paceOn = (scene: Pick<GivenScenario, "lanes" | "obstacles">): number => limitsOn(scene).speed ?? 2;
