import messages from "../i18n/messages/papers-parking.json";
import { words } from "../i18n/words";
import { rows } from "./papers-rows-words";

export const say = words("papersParking", messages, rows);
