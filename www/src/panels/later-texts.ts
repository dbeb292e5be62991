/** What panels say of answers and of the cell under the pointer; the first picture does without it. */
export { encounterOf } from "../texts/encounter";
export { legendOf, readoutOf, weightsOf } from "../texts/readout";
export { showScale } from "../texts/scale-bar";
export { gearMarks } from "./gear-marks";
export { spokenOf } from "./spoken";
