/** Texts shared by the tables of the parking paper and of the road manuscript. */
import messages from "../i18n/messages/papers-rows.json";
import { words } from "../i18n/words";

export const rows = words("papersRows", messages);
