import type { Said } from "./said";

/** A rule with its values apart. */
export const rule = ({ raw }: TemplateStringsArray, ...values: readonly (string | number)[]): Said => ({
  message: String.raw({ raw }, ...values),
  template: raw.join("{}"),
  values: values.map(String),
});
