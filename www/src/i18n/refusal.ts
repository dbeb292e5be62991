import type { Said } from "./said";

/** What the page itself refuses: an error made of a `rule`, whose words and values its Chinese is made of. */
export const refused = (said: Said): Error & Said => Object.assign(new Error(said.message), said);
