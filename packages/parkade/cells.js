// @ts-check
// Brushed cells as text: scenes of many cells cross into the module as one string instead of a million numbers.

import { mismatch, object, text } from "./runtime.js";

/** @typedef {[number, number, number]} Run */

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
/** Rows of packed runs are this far apart. */
const COLUMNS = 4096;
/** Shorter lists cross as they are. */
const MANY = 200;

/** @type {typeof import("./index.js").packRuns} */
export const packRuns = (runs) => (Array.isArray(runs) && runs.every(isRun) ? pack(apart(runs)) : undefined) ?? "";

/** @type {typeof import("./index.js").unpackRuns} */
export function unpackRuns(packed) {
  /** @type {Run[]} */
  const runs = [];
  let value = 0,
    factor = 1,
    gap = -1,
    at = 0;
  for (const letter of text(packed, "text")) {
    const digit = DIGITS.indexOf(letter);
    if (digit < 0 || factor > COLUMNS * COLUMNS) throw unreadable(packed);
    value += (digit & 31) * factor;
    if (digit > 31) {
      factor *= 32;
      continue;
    }
    if (gap < 0) {
      gap = value;
    } else {
      const start = at + gap;
      if (value < 1 || (start % COLUMNS) + value > COLUMNS || start >= COLUMNS * COLUMNS) throw unreadable(packed);
      runs.push([start % COLUMNS, Math.floor(start / COLUMNS), value]);
      at = start + value;
      gap = -1;
    }
    value = 0;
    factor = 1;
  }
  if (gap >= 0 || factor > 1) throw unreadable(packed);
  return runs;
}

/** @param {string} packed */
const unreadable = (packed) => mismatch(packed, "text", "runs as `packRuns` writes them");

/**
 * The scene with long lists of cells packed; what else is wrong with it, the module refuses.
 * @template T
 * @param {T} scene
 * @returns {T}
 */
export function packedScene(scene) {
  return mapCells(object(scene, "scene", "bad-scenario"), (runs) =>
    Array.isArray(runs) && runs.length > MANY ? (pack(runs) ?? runs) : runs,
  );
}

/**
 * The scene with packed cells as runs.
 * @template T
 * @param {T} scene
 * @returns {T}
 */
export function unpackedScene(scene) {
  return mapCells(scene, (runs) => (typeof runs === "string" ? unpackRuns(runs) : runs));
}

/**
 * @template T
 * @param {T} scene
 * @param {(runs: unknown) => unknown} change
 * @returns {T}
 */
function mapCells(scene, change) {
  let all = /** @type {any} */ (scene);
  for (const key of ["obstacles", "costs"]) {
    const list = all?.[key];
    if (!Array.isArray(list)) continue;
    const changed = list.map((one) => {
      if (key === "obstacles" && one?.type !== "cells") return one;
      const runs = change(one?.runs);
      return runs === one?.runs ? one : { ...one, runs };
    });
    if (changed.some((one, i) => one !== list[i])) all = { ...all, [key]: changed };
  }
  return all;
}

/**
 * Text of runs that are whole, ascending and apart; undefined where they are not.
 * @param {readonly Run[]} runs
 */
function pack(runs) {
  let text = "",
    at = 0;
  for (const run of runs) {
    if (!isRun(run)) return undefined;
    const [x, y, count] = run;
    const start = y * COLUMNS + x;
    if (x < 0 || y < 0 || y >= COLUMNS || count < 1 || x + count > COLUMNS || start < at) return undefined;
    text += digits(start - at) + digits(count);
    at = start + count;
  }
  return text;
}

/** @param {unknown} run */
const isRun = (run) => Array.isArray(run) && run.length === 3 && [0, 1, 2].every((i) => Number.isInteger(run[i]));

/** @param {number} n */
function digits(n) {
  let text = "";
  for (; n > 31; n = Math.floor(n / 32)) text += DIGITS[32 + (n % 32)];
  return text + DIGITS[n];
}

/**
 * The same cells in ascending runs that neither overlap nor touch.
 * @param {readonly Run[]} runs
 */
function apart(runs) {
  if (runs.every(([x, y], i) => i === 0 || isBeyond(x, y, runs[i - 1]))) return runs;
  /** @type {Run[]} */
  const merged = [];
  for (const [x, y, count] of [...runs].sort((a, b) => a[1] - b[1] || a[0] - b[0])) {
    const last = merged[merged.length - 1];
    if (last && last[1] === y && x <= last[0] + last[2]) last[2] = Math.max(last[2], x + count - last[0]);
    else merged.push([x, y, count]);
  }
  return merged;
}

/**
 * True if a run that begins here comes after this one and does not touch it.
 * @param {number} x
 * @param {number} y
 * @param {Run | undefined} run
 */
const isBeyond = (x, y, run) => run !== undefined && (y > run[1] || (y === run[1] && x > run[0] + run[2]));
