import type { Failure } from "./protocol";

/** The message of a thrown value, with its code, field and line. */
export function failureOf(error: unknown): Failure {
  if (!(error instanceof Error)) return { code: "internal", path: "", message: String(error) };
  const { code = "internal", path = "", line } = error as Partial<Failure>;
  return { code, path, message: error.message, ...(line !== undefined && { line }) };
}
