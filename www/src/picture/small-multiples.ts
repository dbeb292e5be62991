/** Small charts in rows and columns, one scale a chart, drawn as SVG text: for the page and for documents. */
import { nth } from "../scene/nth";
export interface Chart {
  /** Its row and its column: the setting that is changed, and the figure that is measured. */
  row: string;
  column: string;
  /** The value that is the default, marked by a line. */
  mark: number | null;
  lines: readonly { name: string; points: readonly (readonly [x: number, y: number])[] }[];
}

/** Colours and dashes of lines, told apart without colour, too. */
export const INKS: readonly (readonly [colour: string, dash: string])[] = [
  ["#0072B2", ""],
  ["#D55E00", "5 3"],
  ["#009E73", "1.5 2.5"],
];

const WIDTH = 168,
  HEIGHT = 96,
  LEFT = 40,
  TOP = 34,
  BELOW = 18,
  LABEL = 92;

const escaped = (words: string): string => words.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
const px = (value: number): string => value.toFixed(1);
/** As few digits as tell the ends of a range apart. */
const short = (value: number, span: number): string =>
  Math.abs(value) >= 1000
    ? `${px(value / 1000)}k`
    : value.toFixed(span >= 20 || span === 0 ? 0 : span >= 2 ? 1 : span >= 0.2 ? 2 : 3);

/** The charts as one picture; `title` is for screen readers. */
export function smallMultiples(charts: readonly Chart[], title: string): string {
  const rows = [...new Set(charts.map(({ row }) => row))],
    columns = [...new Set(charts.map(({ column }) => column))];
  const names = [...new Set(charts.flatMap(({ lines }) => lines.map(({ name }) => name)))];
  const width = LABEL + columns.length * WIDTH,
    height = TOP + rows.length * HEIGHT + 4;
  const key = names
    .map((name, i) => {
      const x = LABEL + i * 170;
      return (
        `<line x1="${x}" x2="${x + 24}" y1="10" y2="10" ${stroke(names, name)}/>` +
        `<text x="${x + 30}" y="14">${escaped(name)}</text>`
      );
    })
    .join("");
  const heads = columns
    .map((column, i) => `<text x="${LABEL + i * WIDTH + LEFT}" y="30" font-weight="600">${escaped(column)}</text>`)
    .join("");
  const labels = rows
    .map((row, i) => `<text x="0" y="${TOP + i * HEIGHT + 44}" font-weight="600">${escaped(row)}</text>`)
    .join("");
  const bodies = charts
    .map((chart) => {
      const x = LABEL + columns.indexOf(chart.column) * WIDTH + LEFT,
        y = TOP + rows.indexOf(chart.row) * HEIGHT + 6;
      return `<g transform="translate(${x} ${y})">${body(chart, names)}</g>`;
    })
    .join("");
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 ` +
    `0 ${width} ${height}" width="${width}" height="${height}" role="img" ` +
    `aria-label="${escaped(title).replaceAll('"', "")}" font-family="system-ui, sans-serif" font-size="11" ` +
    `fill="currentColor">${key}${heads}${labels}${bodies}</svg>`
  );
}

function stroke(names: readonly string[], name: string): string {
  const [colour, dash] = nth(INKS, names.indexOf(name) % INKS.length);
  return `fill="none" stroke="${colour}" stroke-width="2"${dash ? ` stroke-dasharray="${dash}"` : ""}`;
}

function body({ lines, mark }: Chart, names: readonly string[]): string {
  const all = lines.flatMap(({ points }) => points).filter(([, y]) => Number.isFinite(y));
  const wide = WIDTH - LEFT - 16,
    tall = HEIGHT - BELOW - 14;
  const frame = `<path d="M0 0V${tall}H${wide}" fill="none" stroke="currentColor" stroke-opacity="0.35"/>`;
  if (all.length === 0) return `${frame}<text x="${wide / 2}" y="${tall / 2}" text-anchor="middle">–</text>`;
  const [left, right] = ends(all.map(([x]) => x)),
    [low, high] = ends(all.map(([, y]) => y));
  const at = ([x, y]: readonly [number, number]): [number, number] => [
    right > left ? ((x - left) / (right - left)) * wide : wide / 2,
    high > low ? tall - ((y - low) / (high - low)) * tall : tall / 2,
  ];
  const drawn = lines
    .map(({ name, points }) => {
      const shown = points.filter(([, y]) => Number.isFinite(y)).map(at);
      return `<polyline points="${shown.map((p) => p.map(px).join(",")).join(" ")}" ${stroke(names, name)}/>${shown
        .map(
          ([x, y]) =>
            `<circle cx="${px(x)}" cy="${px(y)}" r="2" fill="${nth(INKS, names.indexOf(name) % INKS.length)[0]}"/>`,
        )
        .join("")}`;
    })
    .join("");
  const marked =
    mark === null
      ? ""
      : `<line x1="${px(at([mark, low])[0])}" x2="${px(at([mark, low])[0])}" y1="0" y2="${tall}" ` +
        `stroke="currentColor" ` +
        `stroke-opacity="0.3" stroke-dasharray="2 2"/>`;
  const scale =
    `<text x="-5" y="9" ` +
    `text-anchor="end">${short(high, high - low)}</text>${
      high > low ? `<text x="-5" y="${tall}" text-anchor="end">${short(low, high - low)}</text>` : ""
    }<text x="0" y="${tall + 13}">${left}</text><text x="${wide}" y="${tall + 13}" text-anchor="end">${right}</text>`;
  return frame + marked + drawn + scale;
}

const ends = (values: readonly number[]): [number, number] => [Math.min(...values), Math.max(...values)];
