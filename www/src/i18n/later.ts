/** English of the pieces that are fetched later: each that uses such a word imports this. */
import later from "./en-later.json";
import { addEnglish } from "./index";

addEnglish(later);
