import messages from "../i18n/messages/bay-check.json";
import { words } from "../i18n/words";

export const say = words("bayCheck", messages);
