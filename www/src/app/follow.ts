/**
 * What comes once the first picture is there: better paths, trajectories, a place of the car that stays, and commands
 * that edit.
 */
import { follow as followPlans } from "../planning/improver";
import { followSmooth } from "../planning/smoother";
import { keepPlace } from "../view/keep-place";
import type { App } from "./app";
import { join } from "./commands";
import { followGuest } from "./guest";

const following = new WeakSet<App>();

export function follow(app: App): void {
  if (following.has(app)) return;
  following.add(app);
  followPlans(app);
  keepPlace(app.store);
  followSmooth(app);
  followGuest(app);
  void app.controller
    .fetchTools()
    .then(() => import("./edit-commands"))
    .then(({ EDITING }) => join(EDITING));
}
