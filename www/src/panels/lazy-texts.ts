import { piece } from "../view/piece";

/** Texts and marks of panels that come after the first picture. */
export const laterTexts = piece<typeof import("./later-texts")>();
