// @ts-check
// What the command line prints.
import { writeFile } from "node:fs/promises";
import { unwritten } from "./refusal.js";

/** Typed arrays as lists; JSON has no NaN and no infinity. @param {unknown} value @param {number} [indent] */
export const toJSON = (value, indent) =>
  `${JSON.stringify(
    value,
    (_, one) => (ArrayBuffer.isView(one) ? [.../** @type {Float64Array} */ (one)] : one),
    indent,
  )}\n`;

/** @param {string} content @param {string} [file] */
export async function write(content, file) {
  if (file === undefined) {
    process.stdout.write(content);
    return;
  }
  await writeFile(file, content).catch((error) => {
    throw unwritten(file, error);
  });
}

/**
 * @param {readonly string[]} head
 * @param {readonly (readonly (string | number)[])[]} rows
 * @param {"markdown" | "csv"} format
 */
export function table(head, rows, format) {
  const lines =
    format === "csv"
      ? [head, ...rows].map((row) => row.join(","))
      : [head, head.map(() => "---"), ...rows].map((row) => `| ${row.join(" | ")} |`);
  return `${lines.join("\n")}\n`;
}
