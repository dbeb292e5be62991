import type { Failure } from "./protocol";

/** What a thrown thing says, ParkadeError's code and field included. */
export function failureOf(error: unknown): Failure {
  if (!(error instanceof Error)) return { code: "internal", path: "", message: String(error) };
  const { code, path } = error as Partial<Failure>;
  return { code: code ?? "internal", path: path ?? "", message: error.message };
}
