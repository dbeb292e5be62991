/** A refusal: English words, and what they are made of: the field, and a rule with `{}` in the place of each value. */
export interface Said {
  message: string;
  path?: string;
  template?: string;
  values?: readonly string[];
  /** What says it in a language, where no catalogue of rules does. */
  sentence?: (lang: "en" | "zh") => string;
}

/** The words of whatever was thrown. */
export const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
