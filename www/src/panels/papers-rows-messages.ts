/** Texts shared by the tables of the parking paper and of the road manuscript. */
import messages from "../i18n/messages/papers-rows.json";
import { translator } from "../i18n/translator";

export const rows = translator("papersRows", messages);
