/** A drawing on paper at a true scale: an SVG whose units are millimetres, with scale bar and title block. */
import { refused } from "../i18n/refusal";
import { boxOf, type Box, type Point } from "../scene/geometry";
import { escaped } from "./canvas";
import { DRAWING_LAYERS, type DrawingLayer, type SiteDrawing } from "./site-drawing";
import { keysOf } from "../scene/records";

/** Landscape, millimetres. */
export const PAPERS = { A4: [297, 210], A3: [420, 297], A2: [594, 420], A1: [841, 594], A0: [1189, 841] } as const;
export type Paper = keyof typeof PAPERS;
export const SCALES = [50, 100, 200, 500, 1000, 2000] as const;

const EDGE = 10,
  /** Of the title block. */
  BLOCK = { width: 100, height: 34 },
  ROW = 5.5,
  /** Where the values stand in it. */
  VALUES = 26;

/** An area with a colour and a word on it, as bays have. */
export interface SheetArea {
  points: Point[];
  fill: string;
  ink: string;
  text: string;
  isHatched: boolean;
}
export interface ScaleSheet {
  drawing: SiteDrawing;
  shown: ReadonlySet<DrawingLayer>;
  areas: readonly SheetArea[];
  /** 100 is 1:100. */
  scale: number;
  /** Lines of the title block, the first one large; name and value. */
  title: string;
  rows: readonly (readonly [name: string, value: string])[];
  /** Colours of the areas and what they mean. */
  legend: readonly { fill: string; text: string; isHatched: boolean }[];
}

/** The smallest paper on which a drawing fits beside its title block; null where none is large enough. */
export function paperFor(box: Box, scale: number): Paper | null {
  const [width, height] = sizeOn(box, scale);
  return (
    keysOf(PAPERS).find(
      (paper) => width <= PAPERS[paper][0] - 2 * EDGE && height <= PAPERS[paper][1] - 2 * EDGE - BLOCK.height - 4,
    ) ?? null
  );
}

const sizeOn = (box: Box, scale: number): Point => [
  ((box.maxX - box.minX) * 1000) / scale,
  ((box.maxY - box.minY) * 1000) / scale,
];

export const boxOfDrawing = ({ lines }: SiteDrawing): Box => boxOf(lines.flatMap(({ points }) => points));

/** Millimetres of line, colour, dash. */
const STYLES: Record<DrawingLayer, readonly [width: number, colour: string, dash: string]> = {
  ground: [0.5, "#3F444B", ""],
  bays: [0.18, "#5F666F", ""],
  obstacles: [0.35, "#1B1D20", ""],
  parked: [0.18, "#64696F", ""],
  body: [0.35, "#8E3F6C", ""],
  wheels: [0.18, "#0072B2", "1.2 0.8"],
  outlines: [0.13, "#8E3F6C", ""],
  path: [0.25, "#8E3F6C", "3 0.8 0.5 0.8"],
  clearances: [0.13, "#565B62", ""],
  dimensions: [0.25, "#B3261E", ""],
};
const FILLED: Partial<Record<DrawingLayer, string>> = { obstacles: "#C9CCD1", parked: "#E6E8EA" };

/** Throws where no paper is large enough. */
export function sheetSvg(sheet: ScaleSheet): { svg: string; paper: Paper } {
  const box = boxOfDrawing(sheet.drawing),
    paper = paperFor(box, sheet.scale);
  if (!paper) throw refused`At 1:${sheet.scale} the drawing is larger than A0 paper; choose a smaller scale.`;
  const [width, height] = PAPERS[paper],
    [across, up] = sizeOn(box, sheet.scale),
    left = (width - across) / 2,
    low = EDGE + up + Math.max(0, (height - 2 * EDGE - BLOCK.height - 4 - up) / 2),
    unit = 1000 / sheet.scale;
  const place = ([x, y]: Point): Point => [left + (x - box.minX) * unit, low - (y - box.minY) * unit];
  const body = [
    ...sheet.areas.map((area) => areaOf(area, place)),
    ...DRAWING_LAYERS.filter((layer) => sheet.shown.has(layer)).map((layer) => layerOf(sheet.drawing, layer, place)),
    ...sheet.areas.map((area) => wordOf(area, place)),
    scaleBar(sheet.scale, height),
    legendOf(sheet, width, height),
    titleBlock(sheet, width, height),
  ];
  const svg =
    `<svg xmlns="http://www.w3.org/2000/svg" ` +
    `width="${width}mm" height="${height}mm" viewBox="0 0 ${width} ${height}" font-family="sans-serif" font-size="3">` +
    `<title>${escaped(sheet.title)}</title><defs><pattern id="hatch" width="2" height="2" ` +
    `patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><path d="M0 0V2" stroke="#B3261E" ` +
    `stroke-width="0.7"/></pattern></defs>` +
    `<rect width="${width}" height="${height}" fill="#FFFFFF"/>${body.join("")}</svg>\n`;
  return { svg, paper };
}

const number = (value: number): string => String(Math.round(value * 1000) / 1000);

const pathOf = (points: readonly Point[], closed: boolean, place: (point: Point) => Point): string =>
  `M${points.map((point) => place(point).map(number).join(" ")).join("L")}${closed ? "Z" : ""}`;

function layerOf({ lines, texts }: SiteDrawing, layer: DrawingLayer, place: (point: Point) => Point): string {
  const [width, colour, dash] = STYLES[layer],
    open = lines.filter((line) => line.layer === layer),
    fill = FILLED[layer];
  const d = (closed: boolean): string =>
    open
      .filter((line) => line.closed === closed || !fill)
      .map((line) => pathOf(line.points, line.closed, place))
      .join("");
  const stroke = `stroke="${colour}" stroke-width="${width}"${dash ? ` stroke-dasharray="${dash}"` : ""}`;
  const words = texts
    .filter((text) => text.layer === layer)
    .map(({ at, text }) => {
      const [x, y] = place(at);
      return (
        `<text x="${number(x)}" y="${number(y - 0.6)}" text-anchor="middle" font-size="2.2" ` +
        `fill="${colour}" stroke="#FFFFFF" stroke-width="0.5" paint-order="stroke">${escaped(text)}</text>`
      );
    });
  const filled = fill && d(true) ? `<path d="${d(true)}" fill="${fill}" ${stroke}/>` : "",
    drawn = d(false) ? `<path d="${d(false)}" fill="none" ${stroke}/>` : "";
  return `<g id="${layer}">${filled}${drawn}${words.join("")}</g>`;
}

const areaOf = ({ points, fill, isHatched }: SheetArea, place: (point: Point) => Point): string => {
  const d = pathOf(points, true, place);
  return `<path d="${d}" fill="${fill}"/>${isHatched ? `<path d="${d}" fill="url(#hatch)"/>` : ""}`;
};

/** On a disc: a parked car covers the area's colour. */
function wordOf({ points, fill, ink, text, isHatched }: SheetArea, place: (point: Point) => Point): string {
  const placed = points.map(place),
    x = placed.reduce((sum, [px]) => sum + px, 0) / placed.length,
    y = placed.reduce((sum, [, py]) => sum + py, 0) / placed.length;
  return (
    `<circle cx="${number(x)}" cy="${number(y)}" r="2.2" fill="${isHatched ? "#FFFFFF" : fill}"/>` +
    `<text x="${number(x)}" y="${number(y + 1.1)}" text-anchor="middle" font-weight="600" ` +
    `fill="${ink}">${escaped(text)}</text>`
  );
}

/** Five parts of a round length, about 50 mm in all. */
function scaleBar(scale: number, height: number): string {
  const part = [0.5, 1, 2, 5, 10, 20].find((metres) => (metres * 1000) / scale >= 8) ?? 20,
    step = (part * 1000) / scale,
    y = height - EDGE - 6;
  const parts = Array.from(
    { length: 5 },
    (_, i) =>
      `<rect x="${number(EDGE + i * step)}" y="${number(y)}" width="${number(step)}" height="2" fill="${
        i % 2 === 0 ? "#1B1D20" : "#FFFFFF"
      }" stroke="#1B1D20" stroke-width="0.2"/>` +
      `<text x="${number(EDGE + i * step)}" y="${number(y + 5.5)}" text-anchor="middle">${number(i * part)}</text>`,
  );
  parts.push(
    `<text x="${number(EDGE + 5 * step)}" y="${number(y + 5.5)}" text-anchor="middle">${number(5 * part)} m</text>`,
  );
  return `<g id="scale-bar">${parts.join("")}</g>`;
}

function legendOf({ legend }: ScaleSheet, width: number, height: number): string {
  const right = width - EDGE - BLOCK.width - 6;
  return legend
    .map(({ fill, text, isHatched }, i) => {
      const y = height - EDGE - BLOCK.height + i * ROW,
        box = `x="${right - 34}" y="${number(y)}" width="7" height="4"`;
      return (
        `<rect ${box} fill="${fill}" stroke="#5F666F" ` +
        `stroke-width="0.15"/>${
          isHatched ? `<rect ${box} fill="url(#hatch)"/>` : ""
        }<text x="${right - 25}" y="${number(y + 3.2)}">${escaped(text)}</text>`
      );
    })
    .join("");
}

/** A wide letter of a sans serif, and a Chinese sign, as shares of the size of the letters. */
const LETTER = 0.6,
  SIGN = 1;

/** The size of letters at which a line fits in so many millimetres, at most `most`. */
function fontSize(text: string, most: number, room: number): string {
  const ems = [...text].reduce((sum, one) => sum + (one > "\u2e7f" ? SIGN : LETTER), 0);
  return number(Math.min(most, room / ems));
}

function titleBlock({ title, rows }: ScaleSheet, width: number, height: number): string {
  const left = width - EDGE - BLOCK.width,
    top = height - EDGE - BLOCK.height;
  const cells = rows.map(
    ([name, value], i) =>
      `<text x="${left + 2}" y="${number(top + 12 + i * 4.4)}" font-size="2.4" ` +
      `fill="#64696F">${escaped(name)}</text>` +
      `<text x="${left + VALUES}" y="${number(top + 12 + i * 4.4)}" ` +
      `font-size="${fontSize(value, 2.8, BLOCK.width - VALUES - 2)}">${escaped(value)}</text>`,
  );
  return (
    `<g id="title-block"><rect x="${left}" y="${top}" width="${BLOCK.width}" height="${BLOCK.height}" ` +
    `fill="#FFFFFF" stroke="#1B1D20" stroke-width="0.35"/>` +
    `<path d="M${left} ${top + 8}h${BLOCK.width}" stroke="#1B1D20" stroke-width="0.2"/>` +
    `<text x="${left + 2}" y="${top + 5.6}" font-size="${fontSize(title, 4.2, BLOCK.width - 4)}" ` +
    `font-weight="600">${escaped(title)}</text>${cells.join("")}</g>`
  );
}

/** Pages for printing: sheets, and tables on pages of their own; the paper is the sheet's, margins are in the sheet. */
export function printPage(title: string, lang: string, sheet: { svg: string; paper: Paper }, table: string): string {
  const [width, height] = PAPERS[sheet.paper];
  return (
    `<!doctype html><html lang="${lang}"><meta charset="utf-8"><title>${escaped(title)}</title><style>
@page { size: ${width}mm ${height}mm; margin: 0; } body { margin: 0; font: 9pt/1.35 sans-serif; color: #1B1D20; ` +
    `-webkit-print-color-adjust: exact; print-color-adjust: exact; }
svg { display: block; } .table { break-before: page; padding: 12mm; } table { border-collapse: collapse; width: ` +
    `100%; } th, td { padding: 1mm 2mm; border-bottom: .2mm solid #CFCFCA; text-align: right; } :is(th, ` +
    `td):first-child { text-align: left; } td.text { text-align: left; } thead { display: table-header-group; } tr ` +
    `{ break-inside: avoid; } h1 { font-size: 13pt; margin: 0 0 3mm; }
</style>${sheet.svg}${table ? `<div class="table">${table}</div>` : ""}</html>
`
  );
}
