/** The goal that is shown while a scene has a set of goals. */
import { goalPose, isOneGoal, showGoal } from "../scene/model";
import type { State, Store } from "../store";

/** Shows the goal of the set that the focused planner leads to. */
export function followGoals(store: Store): void {
  const follow = ({ scene, results, focus, geometry }: State): void => {
    const { goal } = scene,
      known = goalPose(scene);
    if (isOneGoal(goal)) return;
    const pose = results[focus]?.plan?.goal?.pose ?? (known === scene.start ? geometry?.goal : undefined);
    if (pose && (pose.x !== known.x || pose.y !== known.y || pose.heading !== known.heading))
      showGoal(scene, goal, pose);
  };
  follow(store.state);
  store.subscribe(follow);
}
