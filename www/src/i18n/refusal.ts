import { rule } from "./rule";
import type { Said } from "./said";

/** What the page itself refuses: an error made of a rule, whose words and values its Chinese is made of. */
export const refused = (...said: Parameters<typeof rule>): Error & Said => Object.assign(new Error(), rule(...said));
