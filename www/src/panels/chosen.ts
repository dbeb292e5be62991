import { valueOf } from "./inputs";

/** The one of a list's options that was chosen. */
export function chosenOf<Option extends string>(event: Event, options: readonly Option[]): Option {
  const value = valueOf(event),
    chosen = options.find((option) => option === value);
  if (chosen === undefined) throw new RangeError(`"${value}" is none of ${options.join(", ")}`);
  return chosen;
}
