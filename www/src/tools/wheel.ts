/** Turns of a wheel in any of its units. */

/** Pixels of a line, and of a page. */
const UNITS = [1, 33, 400];

/** Notches, positive away from the user, at least one; and the factor of a zoom. */
export function turnOf({ deltaY, deltaMode, ctrlKey }: WheelEvent): { notches: number; factor: number } {
  const pixels = deltaY * (UNITS[deltaMode] ?? 1);
  // Pinches on a track pad arrive as small turns with Ctrl.
  const factor = Math.exp(-pixels * (ctrlKey ? 0.01 : 0.0015));
  return {
    notches: -Math.sign(pixels) * Math.max(1, Math.round(Math.abs(pixels) / 100)),
    factor: Math.min(4, Math.max(0.25, factor)),
  };
}
