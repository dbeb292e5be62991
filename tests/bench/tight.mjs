// `cargo xtask bench tight`: how tight it can be, drawn and written into the documentation.
//
// Usage: node tight.mjs RESULTS [check], where RESULTS is what the example `tight` printed for `json`. Writes the data,
// the figures and the tables on the page; with `check` only compares the measured cells with the data that are there.
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { figureOf, fileOf, kindTable, magnitude, mapTable, shortTable, withBlock } from "./tight_figures.mjs";

const [file, mode] = process.argv.slice(2);
const at = (path) => new URL(`../../${path}`, import.meta.url);
const DATA = at("tests/data/tight-maps.json"),
  PAGE = at("docs/planners/how-tight.md"),
  FIGURES = at("docs/public/figures/");

const { count, maps, kinds } = JSON.parse(readFileSync(file, "utf8"));

if (mode === "check") check();
else write();

function check() {
  const known = JSON.parse(readFileSync(DATA, "utf8"));
  if (known.count !== count) throw new Error(`${count} scenes a cell; the data have ${known.count}`);
  let measured = 0;
  const changed = maps.flatMap((map, m) =>
    map.cells.flatMap((row, j) =>
      row.flatMap((cell, i) => {
        if (cell === null) return [];
        measured++;
        const old = known.maps[m].cells[j][i];
        return String(old) === String(cell)
          ? []
          : [`${map.family}, ${map.vehicle}, ${map.x[i]} × ${map.y[j]} m: [${cell}], the figure has [${old}]`];
      }),
    ),
  );
  changed.forEach((line) => console.log(line));
  console.log(`${measured} cells planned again, ${changed.length} changed (solved, neither, gear changes)`);
  if (changed.length > 0) process.exitCode = 1;
}

function write() {
  const data = { count, maps: maps.map(({ milliseconds, ...map }) => map), kinds };
  writeFileSync(
    DATA,
    `${JSON.stringify(data)
      .replaceAll("[[", "\n[[")
      .replaceAll(/\{"(family|kind)"/g, '\n{"$1"')}\n`,
  );
  mkdirSync(FIGURES, { recursive: true });
  for (const map of maps) writeFileSync(new URL(fileOf(map), FIGURES), figureOf(map, count));
  const tables = (time) => [
    ["short", shortTable(data)],
    ["maps", mapTable(data, time)],
    ["kinds", kindTable(data)],
  ];
  const page = tables((map) => magnitude(maps.find((one) => fileOf(one) === fileOf(map)).milliseconds[0]));
  writeFileSync(
    PAGE,
    page.reduce((text, [name, block]) => withBlock(text, name, block), readFileSync(PAGE, "utf8")),
  );
  const exact = ({ milliseconds: [half, most] }) => `${half.toFixed(1)} ms, 95 % below ${most.toFixed(0)} ms`;
  for (const [, block] of tables((map) => exact(maps.find((one) => fileOf(one) === fileOf(map)))))
    console.log(`${block}\n`);
}
