// MovingAI maps and questions, and a checker of paths that shares nothing with the planners.
import { readFileSync } from "node:fs";
import { join } from "node:path";

/** Blocked cells, row by row from the north, and the questions of a map. */
export function load(folder, name) {
  const text = readFileSync(join(folder, `${name}.map`), "latin1");
  const lines = text.split(/\r?\n/);
  const height = Number(lines[1].split(/\s+/)[1]);
  const width = Number(lines[2].split(/\s+/)[1]);
  const blocked = new Uint8Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) blocked[y * width + x] = ".GS".includes(lines[4 + y][x]) ? 0 : 1;
  }
  const rows = readFileSync(join(folder, `${name}.map.scen`), "latin1")
    .split(/\r?\n/)
    .slice(1);
  const questions = rows
    .filter((row) => row.trim() !== "")
    .map((row) => {
      const [x0, y0, x1, y1, length] = row.split(/\s+/).slice(4).map(Number);
      return { x0, y0, x1, y1, length };
    });
  return { name, width, height, blocked, questions, text };
}

/** The `count` longest questions and as many of the others, always the same ones. */
export function sample(questions, count) {
  const sorted = [...questions].sort((a, b) => b.length - a.length);
  const rest = sorted.splice(count);
  let state = 12345;
  for (let k = 0; k < count && rest.length > 0; k++) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    sorted.push(...rest.splice(Math.floor((state / 2 ** 32) * rest.length), 1));
  }
  return sorted;
}

/** The length of a path of single steps x, y, …, or what is wrong with it. `cuts`: corners may be cut. */
export function walk(map, question, path, { four = false, cuts = false } = {}) {
  const { width, height, blocked } = map;
  const isBlocked = (x, y) => x < 0 || y < 0 || x >= width || y >= height || blocked[y * width + x] === 1;
  const last = path.length - 2;
  const ends = [path[0], path[1], path[last], path[last + 1]];
  if (path.length < 2 || ends.join() !== [question.x0, question.y0, question.x1, question.y1].join())
    return "other ends";
  let length = 0;
  for (let i = 2; i < path.length; i += 2) {
    const [x, y, dx, dy] = [path[i - 2], path[i - 1], path[i] - path[i - 2], path[i + 1] - path[i - 1]];
    if (Math.max(Math.abs(dx), Math.abs(dy)) !== 1 || (four && dx !== 0 && dy !== 0)) return "no single step";
    if (isBlocked(x + dx, y + dy)) return "through a blocked cell";
    if (!cuts && dx !== 0 && dy !== 0 && (isBlocked(x + dx, y) || isBlocked(x, y + dy))) return "cuts a corner";
    length += dx !== 0 && dy !== 0 ? Math.SQRT2 : 1;
  }
  return length;
}

/** True if a length is the printed one, which has 5 to 8 digits. */
export const agrees = (length, printed) => Math.abs(length - printed) <= printed * 2e-5 + 0.006;
