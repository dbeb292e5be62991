/** The error that a call is refused by: what tests read of it. */
import { ParkadeError } from "parkade";
import { expect } from "vitest";

export function failure(run: () => unknown): { code: string; path: string } {
  try {
    run();
  } catch (error) {
    expect(error).toBeInstanceOf(ParkadeError);
    const { code, path } = error as ParkadeError;
    return { code, path };
  }
  throw new Error("nothing was thrown");
}
