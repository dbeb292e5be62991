import type { Drive, Encounter, Limits, Plan } from "parkade";
import { stopWaitGo, trajectory } from "parkade";
import type { Scenario } from "parkade";
import type { Waiting } from "./protocol";

/** A plan in time, among moving obstacles where there are some; null where no car drives it. */
export function driveOf(scene: Scenario, plan: Plan, rule: Waiting, limits?: Limits): Drive | Encounter | null {
  if (plan.outcome !== "found" || !plan.check.drivable) return null;
  return scene.moving?.length ? stopWaitGo(scene, plan, { rule }) : trajectory(scene, plan, limits);
}
