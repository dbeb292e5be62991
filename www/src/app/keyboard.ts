import { ZOOM_STEP } from "../view/camera";
import type { App } from "./app";

const TYPING = "input:not([type=checkbox]):not([type=range]), textarea, [contenteditable]";
/** Keys that move sliders, press buttons and pick options belong to the control that has the focus. */
const CONTROL_KEYS = /^( |Enter|Tab|Arrow|Home|End|Page)/;

/** Keys of the whole playground, while the focus is in it; of one that is alone on its page, also while it is nowhere in particular. */
export function listenToKeys(
  host: HTMLElement & { alone: boolean; viewing: boolean },
  app: App,
  open: (dialog: "keys" | "papers") => void,
): () => void {
  const listen = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || host.viewing || !isOurs(host, event)) return;
    if (ownKey(app, event, open) || app.controller.handleKey(event)) event.preventDefault();
  };
  document.addEventListener("keydown", listen);
  // Pages have keys of their own: arrows that turn to the next chapter, a letter that opens a search.
  const shield = (event: KeyboardEvent): void => {
    listen(event);
    if (
      !host.alone &&
      !event.ctrlKey &&
      !event.metaKey &&
      !event.altKey &&
      (event.defaultPrevented || isControls(event))
    )
      event.stopPropagation();
  };
  host.addEventListener("keydown", shield);
  return () => {
    document.removeEventListener("keydown", listen);
    host.removeEventListener("keydown", shield);
  };
}

function isOurs(host: HTMLElement & { alone: boolean }, event: KeyboardEvent): boolean {
  const path = event.composedPath();
  const target = path[0];
  if (!path.includes(host) && !(host.alone && target === document.body)) return false;
  return !isControls(event) && !path.some((node) => node instanceof HTMLDialogElement);
}

/** True if the key does something to the control that has the focus. */
function isControls(event: KeyboardEvent): boolean {
  const [target] = event.composedPath();
  if (!(target instanceof HTMLElement)) return false;
  return (
    target.matches(TYPING) || (CONTROL_KEYS.test(event.key) && target.matches("button, input, select, [role=region]"))
  );
}

function ownKey(app: App, event: KeyboardEvent, open: (dialog: "keys" | "papers") => void): boolean {
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (key === "z") event.shiftKey ? app.store.redo() : app.store.undo();
    else if (key === "y") app.store.redo();
    else return false;
    return true;
  }
  if (event.altKey) return false;
  switch (key) {
    case "\\":
      app.cycleMode();
      return true;
    case ",":
      app.cycleLayers(-1);
      return true;
    case ".":
      app.cycleLayers(1);
      return true;
    case "?":
      open("keys");
      return true;
    case "y":
      open("papers");
      return true;
    case "a":
      app.player.toggle();
      return true;
    case "0":
      app.controller.fit();
      return true;
    case "+":
    case "=":
      app.controller.zoom(ZOOM_STEP);
      return true;
    case "-":
      app.controller.zoom(1 / ZOOM_STEP);
      return true;
    default:
      return false;
  }
}
