/** Texts of the tools. */
import type { State } from "../store";

const WORDS = {
  crosses: { en: "This corner would cross an edge.", zh: "该顶点会使边相交。" },
  tight: {
    en: "The road is too wide to turn here. Lengthen its sections or widen the bend.",
    zh: "道路过宽，无法在此转弯。请加长路段或放缓弯道。",
  },
  slots: { en: "slots", zh: "个车位" },
  slot: { en: "slot", zh: "个车位" },
  left: { en: "left", zh: "左" },
  right: { en: "right", zh: "右" },
  row: { en: "row", zh: "总长" },
  aisle: { en: "aisle", zh: "通道" },
  free: { en: "free", zh: "空余" },
  radius: { en: "radius", zh: "半径" },
} as const;

export const word = (state: State, key: keyof typeof WORDS): string => WORDS[key][state.lang];
