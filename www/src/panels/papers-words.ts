import messages from "../i18n/messages/papers.json";
import { words } from "../i18n/words";

export const say = words("papers", messages);
