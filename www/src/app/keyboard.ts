import type { App } from "./app";
import { chordOf, runChord } from "./commands";

const TYPING = "input:not([type=checkbox]):not([type=range]), textarea, [contenteditable]";
/** Keys that move sliders, press buttons and pick options belong to the control that has the focus. */
const CONTROL_KEYS = /^( |Enter|Tab|Arrow|Home|End|Page)/;

/**
 * Keys of the whole playground, while the focus is in it; of one that is alone on its page, also while it is nowhere in
 * particular.
 */
export function listenToKeys(host: HTMLElement & { alone: boolean; viewing: boolean }, app: App): () => void {
  const listen = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || host.viewing || !isOurs(host, event)) return;
    if (takesKey(app, event)) event.preventDefault();
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
      (event.defaultPrevented || isControls(event) || (!host.viewing && isMaps(event)))
    )
      event.stopPropagation();
  };
  host.addEventListener("keydown", shield);
  return () => {
    document.removeEventListener("keydown", listen);
    host.removeEventListener("keydown", shield);
  };
}

/** True where a command or the tool in force used the key. */
export function takesKey(app: App, event: KeyboardEvent): boolean {
  const chord = chordOf(event);
  return (chord !== null && runChord(app, chord)) || app.controller.handleKey(event);
}

function isOurs(host: HTMLElement & { alone: boolean }, event: KeyboardEvent): boolean {
  const path = event.composedPath();
  const target = path[0];
  if (!path.includes(host) && !(host.alone && target === document.body)) return false;
  return !isControls(event) && !path.some((node) => node instanceof HTMLDialogElement);
}

/** True if the key would do something to the map that has the focus, were there something to do it to. */
function isMaps(event: KeyboardEvent): boolean {
  const [target] = event.composedPath();
  return target instanceof HTMLElement && CONTROL_KEYS.test(event.key) && target.matches("[role=application]");
}

/** True if the key does something to the control that has the focus. */
function isControls(event: KeyboardEvent): boolean {
  const [target] = event.composedPath();
  if (!(target instanceof HTMLElement)) return false;
  return (
    target.matches(TYPING) || (CONTROL_KEYS.test(event.key) && target.matches("button, input, select, [role=region]"))
  );
}
