/** The keys of a table that has no others: one that is written out where it is declared. */
export const keysOf = <Key extends string>(table: { readonly [Known in Key]?: unknown }): Key[] =>
  Object.keys(table) as Key[];

/** True of what has keys. */
export const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null;

/** The fields of what came from outside; none where it has none. */
export const fieldsOf = (value: unknown): Record<string, unknown> => (isRecord(value) ? value : {});
