/** Vehicle path planners. SI units, radians; x east, y north, headings counter-clockwise from east. */

export type * from "./settings.js";
export * from "./types/scene.js";
export * from "./types/import.js";
export * from "./types/planner.js";
export * from "./types/plan.js";
export * from "./types/trace.js";
export * from "./types/check.js";
export * from "./types/drive.js";
export * from "./types/audit.js";
export * from "./types/picture.js";
export * from "./types/papers.js";
