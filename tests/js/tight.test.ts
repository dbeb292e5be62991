/**
 * How tight it can be: the documentation's figures and tables against the data that `cargo xtask bench tight` measured.
 */
import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { INK, SCALES } from "../bench/heat_map.mjs";
import {
  figureOf,
  fileOf,
  kindTable,
  leastSolved,
  magnitude,
  mapTable,
  shortTable,
  withBlock,
} from "../bench/tight_figures.mjs";
import type { Tight } from "../bench/tight_figures.mjs";

const read = (path: string): string => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const data = JSON.parse(read("tests/data/tight-maps.json")) as Tight;
const page = read("docs/planners/how-tight.md");

interface Text {
  x: number;
  y: number;
  text: string;
}
const textsOf = (svg: string): Text[] =>
  [...svg.matchAll(/<text x="([\d.]+)" y="(\d+)"[^>]*>([^<]*)<\/text>/g)].map(([, x, y, text]) => ({
    x: Number(x),
    y: Number(y),
    text: text!,
  }));

test.each(data.maps)("the figure of $family for the $vehicle is drawn from its data", (map) => {
  const svg = read(`docs/public/figures/${fileOf(map)}`);
  expect(svg).toBe(figureOf(map, data.count));
  expect(Buffer.byteLength(svg)).toBeLessThan(15_000);
  for (const one of [page, read("docs/zh/planners/how-tight.md")]) expect(one).toContain(`(/figures/${fileOf(map)})`);
  expect([...svg.matchAll(/>(\w[\w -]+, m)</g)]).toHaveLength(4);
});

test.each(data.maps)("each number over $family for the $vehicle stands where its sizes cross", (map) => {
  const texts = textsOf(read(`docs/public/figures/${fileOf(map)}`));
  const isSize = ({ text }: Text) => /^\d+\.\d$/.test(text);
  const left = texts.filter(({ x, text }) => isSize({ x, y: 0, text }) && x < 62);
  const below = texts.filter((one) => isSize(one) && one.x > 62);
  const cells = texts.filter(({ text }) => /^(\d+|–)$/.test(text));
  expect([left.length, below.length]).toEqual([map.y.length, map.x.length].map((n) => 2 * n));
  const [solved, changes] = [0, 1].map((panel) =>
    map.y.map((up, j) =>
      map.x.map((along, i) => {
        const row = left[panel * map.y.length + j]!,
          column = below[panel * map.x.length + i]!;
        expect([row.text, column.text]).toEqual([up.toFixed(1), along.toFixed(1)]);
        return cells
          .filter(({ x, y }) => x === column.x && y === row.y)
          .map(({ text }) => text)
          .join(" and ");
      }),
    ),
  );
  expect(solved).toEqual(map.cells.map((row) => row.map(([count]) => String(Math.round((count / data.count) * 100)))));
  expect(changes).toEqual(map.cells.map((row) => row.map(([, , median]) => (median === null ? "–" : String(median)))));
});

test("every dot stands for a size with an undecided scene", () => {
  for (const map of data.maps) {
    const dots = figureOf(map, data.count).match(/<circle /g)!.length - 1;
    expect(dots, fileOf(map)).toBe(map.cells.flat().filter(([, undecided]) => undecided > 0).length);
  }
});

test("a size without a path has no gear changes, and outcomes add up to the scenes", () => {
  for (const [solved, undecided, changes] of data.maps.flatMap(({ cells }) => cells.flat())) {
    expect(solved + undecided).toBeLessThanOrEqual(data.count);
    expect(changes === null).toBe(solved === 0);
  }
  expect(data.kinds.reduce((sum, { scenes }) => sum + scenes, 0)).toBe(600);
});

test("the page's tables say what the data say; times are orders of magnitude", () => {
  const times = [...page.matchAll(/\| ([^|]*) \|\n/g)]
    .map(([, last]) => last!)
    .filter((last) => last.startsWith("about "));
  expect(times).toHaveLength(data.maps.length);
  for (const time of times) expect(time).toMatch(/^about (1|10|100) (ms|s)$/);
  const left = [...times];
  expect(
    withBlock(
      page,
      "maps",
      mapTable(data, () => left.shift()!),
    ),
  ).toBe(page);
  expect(withBlock(page, "kinds", kindTable(data))).toBe(page);
  expect(withBlock(page, "short", shortTable(data))).toBe(page);
  expect([0.4, 8, 31, 32, 900].map(magnitude)).toEqual([
    "about 1 ms",
    "about 10 ms",
    "about 10 ms",
    "about 100 ms",
    "about 1 s",
  ]);
  expect(() => withBlock(page, "nothing", "")).toThrow("the page has no block nothing");
});

test("the least size is the one from which on no scene is left unsolved", () => {
  const cells = [
    [2, 1, 2, 2],
    [0, 2, 2, 2],
    [0, 0, 0, 2],
    [0, 0, 0, 1],
  ].map((row) => row.map((solved) => [solved, 0, null] as [number, number, null]));
  const map = {
    family: "kerb",
    vehicle: "sedan",
    length: 4.7,
    width: 1.9,
    x: [0.3, 0.5, 0.7, 0.9],
    y: [4, 5, 6, 7],
    cells,
  };
  expect([4, 5, 6, 7].map((up) => leastSolved(map, 2, up))).toEqual([0.7, 0.5, 0.9, null]);
  expect(leastSolved(map, 2, null)).toBe(null);
  expect(leastSolved({ ...map, cells: cells.map((row) => row.map(() => [2, 0, 1])) }, 2, null)).toBe(0.3);
});

/** WCAG's contrast of two colours. */
function contrast(...colours: [string, string]): number {
  const light = colours.map((colour) => {
    const [r, g, b] = [1, 3, 5]
      .map((at) => parseInt(colour.slice(at, at + 2), 16) / 255)
      .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r! + 0.7152 * g! + 0.0722 * b! + 0.05;
  });
  return Math.max(...light) / Math.min(...light);
}

test("numbers and axes can be read in either scheme", () => {
  const pairs = [
    ...Object.values(SCALES).flatMap(({ light, dark }) => [...light, ...dark]),
    [INK.light, "#ffffff"],
    [INK.dark, "#1b1b1f"],
  ] as [string, string][];
  expect(pairs).toHaveLength(26);
  for (const [fill, text] of pairs) expect(contrast(fill, text), `${text} on ${fill}`).toBeGreaterThanOrEqual(4.5);
});
