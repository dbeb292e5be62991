import type { Said } from "./said";

/** What the page itself refuses: an error made of a `rule`, whose words and values its Chinese is made of. */
export class Refusal extends Error implements Said {
  declare readonly template: string;
  declare readonly values: readonly string[];

  constructor(said: Said) {
    super(said.message);
    Object.assign(this, said);
  }
}
