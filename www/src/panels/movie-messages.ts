import messages from "../i18n/messages/movie.json";
import { translator } from "../i18n/translator";

export const say = translator("movie", messages);
