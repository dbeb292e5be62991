/** What follows the store once the first picture is there: better paths, trajectories, and a place of the car that stays. */
import { follow as followPlans } from "../planning/improver";
import { followSmooth } from "../planning/smoother";
import { keepPlace } from "../view/keep-place";
import { followGuest } from "./guest";
import type { App } from "./app";

const following = new WeakSet<App>();

export function follow(app: App): void {
  if (following.has(app)) return;
  following.add(app);
  followPlans(app);
  keepPlace(app.store);
  followSmooth(app);
  followGuest(app);
}
