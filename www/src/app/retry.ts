/** Milliseconds. */
const FIRST_WAIT = 2000;
const LONGEST_WAIT = 60_000;

/**
 * Tries until it succeeds: after ever longer waits, and as soon as the network is back. What went wrong is told once.
 * Null when it is aborted.
 */
export async function persistently<T>(
  run: () => Promise<T>,
  failed: (error: unknown) => void,
  signal: AbortSignal,
): Promise<T | null> {
  for (let wait = FIRST_WAIT; !signal.aborted; wait = Math.min(2 * wait, LONGEST_WAIT)) {
    try {
      return await run();
    } catch (error) {
      if (wait === FIRST_WAIT) failed(error);
    }
    await new Promise<void>((resolve) => {
      const next = (): void => {
        clearTimeout(timer);
        removeEventListener("online", next);
        resolve();
      };
      const timer = setTimeout(next, wait);
      addEventListener("online", next);
    });
  }
  return null;
}
