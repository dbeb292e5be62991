/** Words of the pieces that are fetched later: each that uses such a word imports this. */
import { addMessages } from "./index";
import later from "./messages/later.json";

addMessages(later);
