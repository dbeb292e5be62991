import type { Pose } from "parkade";

/** The value at a place that must be there: a list's, a string's or a column's. */
export function nth<Value>(list: ArrayLike<Value>, place: number): Value {
  const value = list[place];
  if (value === undefined) throw new RangeError(`no value ${place} in a list of ${list.length}`);
  return value;
}

/** The value at the end of a list that is not empty. */
export const lastIn = <Value>(list: ArrayLike<Value>): Value => nth(list, list.length - 1);

/** The pose at a place of a column of poses: x, y, heading, x, … */
export const poseAt = (column: ArrayLike<number>, place: number): Pose => ({
  x: nth(column, 3 * place),
  y: nth(column, 3 * place + 1),
  heading: nth(column, 3 * place + 2),
});
