/** The scene without some of its things. */
import { withSet } from "./goals";
import { goalPose, withCosts, type Scene } from "./model";
import { findThing } from "./scene-objects";

export function removeThings(scene: Scene, ids: readonly string[]): Scene {
  const remove = { obstacle: removeObstacle, slot: removeSlot, moving: removeMoving, cost: removeCost };
  return ids.reduce((next, id) => {
    const found = findThing(next, id);
    return found ? remove[found.kind](next, id) : next;
  }, scene);
}

export const removeObstacle = (scene: Scene, id: string): Scene => ({
  ...scene,
  obstacles: (scene.obstacles ?? []).filter((o) => o.id !== id),
});
export const removeCost = (scene: Scene, id: string): Scene =>
  withCosts(
    scene,
    (scene.costs ?? []).filter((one) => one.id !== id),
  );

/** Without the last one the scene holds no list of them. */
export function removeMoving({ moving = [], ...scene }: Scene, id: string): Scene {
  const left = moving.filter((m) => m.id !== id);
  return left.length > 0 ? { ...scene, moving: left } : scene;
}

export const removeSlot = (scene: Scene, id: string): Scene => ({
  ...withoutGoal(scene, id),
  slots: (scene.slots ?? []).filter((s) => s.id !== id),
});

/** A goal in the slot alone stays where it was, as a pose. */
function withoutGoal(scene: Scene, id: string): Scene {
  const { goal } = scene,
    named = "slot" in goal ? [goal.slot] : "slots" in goal ? goal.slots : [];
  if (!named.includes(id) || named === "free") return scene;
  const slots = named.filter((one) => one !== id);
  return "slots" in goal && slots.length > 0 ? withSet(scene, { ...goal, slots }) : { ...scene, goal: goalPose(scene) };
}
