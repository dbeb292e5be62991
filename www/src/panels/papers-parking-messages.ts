import messages from "../i18n/messages/papers-parking.json";
import { translator } from "../i18n/translator";
import { rows } from "./papers-rows-messages";

export const say = translator("papersParking", messages, rows);
