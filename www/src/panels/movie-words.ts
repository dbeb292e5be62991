import messages from "../i18n/messages/movie.json";
import { words } from "../i18n/words";

export const say = words("movie", messages);
