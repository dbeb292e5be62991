/** The public API of an embedded playground: the same names for the element and for messages to a frame. */

/** Attributes that pass from the element to what it loads. */
export const ATTRIBUTES = [
  "src",
  "scene",
  "planners",
  "layout",
  "controls",
  "editable",
  "autoplay",
  "speed",
  "layers",
  "smooth",
  "theme",
  "lang",
  "budget-ms",
  "wheel",
  "worker-url",
  "wasm-url",
] as const;

/** Properties that can be set before there is anything to set them on. */
export const SETTABLE = ["sceneData", "params", "playhead", "camera"] as const;

export const READABLE = ["results", "canUndo", "canRedo"] as const;

/** Methods; through the element and through messages each gives a promise. */
export const METHODS = [
  "plan",
  "cancel",
  "play",
  "pause",
  "seek",
  "undo",
  "redo",
  "reset",
  "fit",
  "getScene",
  "setScene",
  "openLink",
  "toBlob",
  "toSVG",
  "toCSV",
  "shareURL",
  "settled",
] as const;

export const EVENTS = [
  "ready",
  "scene-change",
  "plan-start",
  "plan-progress",
  "plan-result",
  "plan-complete",
  "seek",
  "select",
  "error",
  "progress",
  "visibility",
] as const;

/** Parts that can be styled from outside. */
export const PARTS = ["toolbar", "canvas", "panel", "table", "chart", "timeline", "handle", "chip"] as const;
