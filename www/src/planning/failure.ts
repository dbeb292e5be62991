import type { Failure } from "./protocol";

/** What a thrown value says of itself, and its message. */
export function failureOf(error: unknown): Failure {
  if (!(error instanceof Error)) return { code: "internal", path: "", message: String(error) };
  return { code: "internal", path: "", ...error, message: error.message };
}
