import messages from "../i18n/messages/papers.json";
import { translator } from "../i18n/translator";

export const say = translator("papers", messages);
