import messages from "../i18n/messages/papers-road.json";
import { translator } from "../i18n/translator";
import { rows } from "./papers-rows-messages";

export const say = translator("papersRoad", messages, rows);

export const FLAGS = [
  "flag0",
  "flag1",
  "flag2",
  "flag3",
  "flag4",
  "flag5",
  "flag6",
  "flag7",
  "flag8",
  "flag9",
  "flag10",
] as const;
