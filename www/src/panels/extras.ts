/** What comes right after the first picture: layers, texts, and elements beside a panel's map. */
import type { App } from "../app/app";
import { follow as followStore } from "../app/follow";
import { taskIn } from "../app/task-link";
import "./choices";
import "./failure-line";
import "./smooth-switch";

export * from "../view/layers/later";
export * from "./later-texts";

/** Follows the store, and shows the task of the page's address. */
export function follow(app: App): void {
  followStore(app);
  const task = taskIn(location.hash);
  if (task) void app.fetchPart(async () => (await import("./task")).showTask(app, task));
}
