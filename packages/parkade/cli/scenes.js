// @ts-check
// Where the scenes of `parkade batch` are.
import { createReadStream, readFileSync } from "node:fs";
import { readdir, stat } from "node:fs/promises";
import { join } from "node:path";
import { Refused, reason } from "./refusal.js";
import { hashOf } from "./results.js";

/**
 * Bytes of a file.
 * @typedef {{ name: string, file: string, from: number, length: number }} Scene
 */

/**
 * Every .json below a folder, every line of a .jsonl, or a .json itself, with the hash of its content.
 * @param {string} place
 * @returns {AsyncGenerator<{ scene: Scene, content: string }>}
 */
export async function* scenes(place) {
  if (place.endsWith(".jsonl")) {
    yield* lines(place);
    return;
  }
  if (place.endsWith(".json") && (await stat(place)).isFile()) {
    yield whole(place);
    return;
  }
  const entries = await readdir(place, { recursive: true, withFileTypes: true }).catch((error) => {
    throw new Refused(`${place}: ${reason(error)}`);
  });
  const files = entries
    .filter((entry) => entry.isFile() && entry.name.endsWith(".json"))
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .sort();
  for (const file of files) yield whole(file);
}

/** @param {string} file */
function whole(file) {
  const bytes = read(file);
  return { scene: { name: file.replaceAll("\\", "/"), file, from: 0, length: bytes.length }, content: hashOf(bytes) };
}

/** @param {string} file */
function read(file) {
  try {
    return readFileSync(file);
  } catch (error) {
    throw new Refused(`${file}: ${reason(error)}`);
  }
}

/** @param {string} file */
async function* lines(file) {
  let at = 0,
    from = 0,
    rest = Buffer.alloc(0);
  /** @param {Buffer} line */
  const one = (line) => {
    const scene = { name: `${file}:${++at}`, file, from, length: line.at(-1) === CR ? line.length - 1 : line.length };
    from += line.length + 1;
    const bytes = line.subarray(0, scene.length);
    return bytes.every((byte) => byte === 32 || byte === 9) ? [] : [{ scene, content: hashOf(bytes) }];
  };
  for await (const block of createReadStream(file, { highWaterMark: 1 << 20 })) {
    let text = rest.length > 0 ? Buffer.concat([rest, block]) : block;
    for (let end = text.indexOf(LF); end >= 0; end = text.indexOf(LF)) {
      yield* one(text.subarray(0, end));
      text = text.subarray(end + 1);
    }
    rest = text;
  }
  if (rest.length > 0) yield* one(rest);
}

const LF = 10,
  CR = 13;
