/** A drawing as DXF (R12, ASCII, metres): what every CAD program reads. */
import { DRAWING_LAYERS, type DrawingLayer, type SiteDrawing } from "./site-drawing";

/** AutoCAD's colour numbers: by them programs tell layers apart. */
const COLOURS: Record<DrawingLayer, number> = {
  ground: 8,
  bays: 9,
  obstacles: 7,
  parked: 8,
  body: 5,
  wheels: 4,
  outlines: 140,
  path: 6,
  clearances: 3,
  dimensions: 1,
};
/** Height of letters, metres. */
const LETTERS = 0.25;

export function dxfOf(
  { lines, texts }: SiteDrawing,
  shown: ReadonlySet<DrawingLayer> = new Set(DRAWING_LAYERS),
): string {
  const out: string[] = [];
  const put = (...groups: (readonly [number, string | number])[]): void => {
    for (const [code, value] of groups)
      out.push(String(code), typeof value === "number" ? decimal(code, value) : value);
  };
  put([0, "SECTION"], [2, "HEADER"], [9, "$ACADVER"], [1, "AC1009"], [9, "$INSUNITS"], [70, 6], [0, "ENDSEC"]);
  put([0, "SECTION"], [2, "TABLES"], [0, "TABLE"], [2, "LAYER"], [70, DRAWING_LAYERS.length]);
  for (const layer of DRAWING_LAYERS)
    put([0, "LAYER"], [2, nameOf(layer)], [70, 0], [62, COLOURS[layer]], [6, "CONTINUOUS"]);
  put([0, "ENDTAB"], [0, "ENDSEC"], [0, "SECTION"], [2, "ENTITIES"]);
  for (const { layer, points, closed } of lines) {
    if (!shown.has(layer)) continue;
    put([0, "POLYLINE"], [8, nameOf(layer)], [66, 1], [10, 0], [20, 0], [70, closed ? 1 : 0]);
    for (const [x, y] of points) put([0, "VERTEX"], [8, nameOf(layer)], [10, x], [20, y]);
    put([0, "SEQEND"], [8, nameOf(layer)]);
  }
  for (const { layer, at, text } of texts)
    if (shown.has(layer)) put([0, "TEXT"], [8, nameOf(layer)], [10, at[0]], [20, at[1]], [40, LETTERS], [1, text]);
  put([0, "ENDSEC"], [0, "EOF"]);
  return `${out.join("\r\n")}\r\n`;
}

export const nameOf = (layer: DrawingLayer): string => layer.toUpperCase();

/** Codes from 60 to 79 are whole numbers. */
const decimal = (code: number, value: number): string =>
  code >= 60 && code < 80 ? String(value) : (Math.round(value * 1e4) / 1e4).toFixed(4);
