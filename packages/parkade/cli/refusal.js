// @ts-check
// How the command refuses: the words name what was given, the rule, and what was probably meant.
import { ParkadeError } from "../node.js";

/** Bad input, in words for people. */
export class Refused extends Error {}

/** An option as it was given; an empty value is shown. @param {string} option @param {string} [value] */
export const given = (option, value) => `--${option} ${value || '""'}`;

/**
 * What the library refuses, by the options that the values come from.
 * @template T
 * @param {Record<string, string>} names of options, and of the same in the API
 * @param {() => T} use
 * @returns {T}
 */
export function byOption(names, use) {
  try {
    return use();
  } catch (error) {
    const option = Object.keys(names).find((one) => error instanceof ParkadeError && names[one] === error.path);
    if (option === undefined) throw error;
    const { path, message } = /** @type {ParkadeError} */ (error);
    throw new Refused(`--${option}${explained({ path, message }).slice(path.length)}`);
  }
}

/** Meanings of the system's error codes. @type {Record<string, string>} */
const REASONS = {
  ENOENT: "there is no such file",
  EISDIR: "is a folder",
  ENOTDIR: "a part of its path is a file, not a folder",
  EACCES: "permission denied",
  ENOSPC: "no space left on the device",
  EROFS: "the file system is read-only",
  ENAMETOOLONG: "the name is too long",
};

/** @param {unknown} error */
export function reason(error) {
  const { code, message } = /** @type {NodeJS.ErrnoException} */ (error);
  return (code !== undefined && REASONS[code]) || message;
}

/** A file that cannot be written. @param {string} file @param {unknown} error */
export function unwritten(file, error) {
  const { code } = /** @type {NodeJS.ErrnoException} */ (error);
  return new Refused(`${file}: ${code === "ENOENT" ? "its folder does not exist" : reason(error)}`);
}

/**
 * "; did you mean …?" where a known word is near: a third of its letters may be wrong.
 * @param {string} word
 * @param {readonly string[]} known
 * @param {string} [before] what stands before each
 */
export function meant(word, known, before = "") {
  const near = known
    .map((one) => ({ one, by: distance(word.toLowerCase(), one.toLowerCase()) }))
    .sort((a, b) => a.by - b.by)[0];
  return near !== undefined && near.by <= Math.max(1, Math.floor(near.one.length / 3))
    ? `; did you mean ${before}${near.one}?`
    : "";
}

/**
 * The library's message; where it lists the words that are right, with the one that was probably meant.
 * @param {{ path: string, message: string }} error
 */
export function explained({ path, message }) {
  const fields = /; there are (.+)$/.exec(message)?.[1],
    [, words, got = ""] = /must be (.+), got "(.*)"$/.exec(message) ?? [];
  if (fields !== undefined) return message + meant(path.split(".").at(-1) ?? "", fields.split(", "));
  return words === undefined ? message : message + meant(got, words.split(/, | or /));
}

/**
 * Damerau and Levenshtein's: letters that are wrong, missing, too many, or swapped with the next.
 * @param {string} a
 * @param {string} b
 */
function distance(a, b) {
  /** @type {number[][]} */
  const rows = [Array.from({ length: b.length + 1 }, (_, i) => i)];
  const at = (/** @type {number} */ i, /** @type {number} */ j) => rows[i]?.[j] ?? 0;
  for (let i = 1; i <= a.length; i++) {
    rows[i] = [i];
    for (let j = 1; j <= b.length; j++) {
      const isSwap = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      rows[i]?.push(
        Math.min(
          at(i - 1, j) + 1,
          at(i, j - 1) + 1,
          at(i - 1, j - 1) + (a[i - 1] === b[j - 1] ? 0 : 1),
          isSwap ? at(i - 2, j - 2) + 1 : Infinity,
        ),
      );
    }
  }
  return at(a.length, b.length);
}
