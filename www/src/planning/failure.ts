import type { Failure } from "./protocol";

/** The message of a thrown value, with ParkadeError's code and field. */
export function failureOf(error: unknown): Failure {
  if (!(error instanceof Error)) return { code: "internal", path: "", message: String(error) };
  const { code, path } = error as Partial<Failure>;
  return { code: code ?? "internal", path: path ?? "", message: error.message };
}
