import type { SitePlan, SitePlanLine } from "parkade/siteplan";
import { TAU, radians, type Point } from "../scene/geometry";
import { after, bulged, circleArc, ellipseArc, IDENTITY, mapped, spline, type Affine } from "./curves";
import { numberIn, numberOf, recordsOf, textIn, type DxfRecord } from "./dxf-groups";
import { PlanBuilder, SitePlanError } from "./site-plan";
import { lastIn, nth } from "../scene/nth";
import { rule } from "../i18n/rule";

/** Metres per unit by the header's `$INSUNITS`. */
const UNITS: Record<number, number> = {
  1: 0.0254,
  2: 0.3048,
  4: 0.001,
  5: 0.01,
  6: 1,
  7: 1000,
  10: 0.9144,
  14: 0.1,
  21: 1200 / 3937,
};
/** Blocks within blocks; and copies of one block in a grid. */
const DEEPEST = 8,
  MOST_COPIES = 2000,
  MOST_INSERTS = 20_000,
  MOST_ENTITIES = 200_000;

interface Block {
  base: Point;
  entities: DxfRecord[];
}

export function readDxf(text: string): SitePlan {
  if (text.startsWith("AutoCAD Binary DXF")) throw new SitePlanError(rule`this DXF is binary; save it as text (ASCII)`);
  if (/^AC10\d\d/.test(text)) throw new SitePlanError(rule`this is a DWG file; save it as DXF`);
  const { entities, blocks, unit } = sectionsOf(text);
  const builder = new PlanBuilder();
  new Drawing(blocks, builder).draw(entities, IDENTITY, null, 0);
  return builder.build("dxf", unit);
}

function sectionsOf(text: string): { entities: DxfRecord[]; blocks: Map<string, Block>; unit: number | null } {
  const entities: DxfRecord[] = [],
    blocks = new Map<string, Block>();
  let section = "",
    block: Block | null = null,
    unit: number | null = null,
    kept = 0;
  for (const record of recordsOf(text)) {
    if (section !== "" && section !== "HEADER" && ++kept > MOST_ENTITIES)
      throw new SitePlanError(rule`a drawing must have at most ${MOST_ENTITIES} entities`, record.line);
    if (record.type === "SECTION") {
      section = textIn(record, 2, "");
      if (section === "HEADER") unit = unitOf(record);
    } else if (record.type === "ENDSEC") section = "";
    else if (section === "ENTITIES") entities.push(record);
    else if (section === "BLOCKS") {
      if (record.type === "BLOCK") {
        block = { base: pointIn(record, 10), entities: [] };
        blocks.set(textIn(record, 2, ""), block);
      } else if (record.type === "ENDBLK") block = null;
      else block?.entities.push(record);
    }
  }
  return { entities, blocks, unit };
}

function unitOf(header: DxfRecord): number | null {
  const at = header.groups.findIndex(({ code, value }) => code === 9 && value === "$INSUNITS"),
    group = header.groups[at + 1];
  return at >= 0 && group?.code === 70 ? (UNITS[numberOf(group)] ?? null) : null;
}

const pointIn = (record: DxfRecord, code: number, otherwise?: number): Point => [
  numberIn(record, code, otherwise),
  numberIn(record, code + 10, otherwise),
];

/** Points whose groups may come many times. */
function pointsIn(record: DxfRecord, code: number): Point[] {
  const xs = record.groups.filter((one) => one.code === code),
    ys = record.groups.filter((one) => one.code === code + 10);
  if (xs.length !== ys.length) throw new SitePlanError(rule`${record.type} must have as many y as x`, record.line);
  return xs.map((x, i) => [numberOf(x), numberOf(nth(ys, i))]);
}

class Drawing {
  private inserts = 0;

  constructor(
    private readonly blocks: ReadonlyMap<string, Block>,
    private readonly builder: PlanBuilder,
  ) {}

  /** `layer`: that of the block's place, which its entities on layer 0 take. */
  draw(records: readonly DxfRecord[], place: Affine, layer: string | null, depth: number): void {
    for (let i = 0; i < records.length; i++) {
      const record = nth(records, i),
        own = textIn(record, 8, "0"),
        on = own === "0" && layer !== null ? layer : own;
      // Sheets for paper are no part of the site.
      if (numberIn(record, 67, 0) === 1) continue;
      // The plane of an entity that is drawn from below is mirrored.
      const seen: Affine =
        numberIn(record, 230, 1) < 0 && record.type !== "LINE" ? after(place, [-1, 0, 0, 1, 0, 0]) : place;
      if (record.type === "INSERT") this.insert(record, seen, on, depth);
      else if (record.type === "POLYLINE") {
        const vertices: DxfRecord[] = [];
        while (records[i + 1]?.type === "VERTEX") vertices.push(nth(records, ++i));
        if (records[i + 1]?.type === "SEQEND") i++;
        this.put(on, oldPolyline(record, vertices), seen, record);
      } else this.put(on, lineOf(record), seen, record);
    }
  }

  private put(layer: string, line: SitePlanLine | null, place: Affine, record: DxfRecord): void {
    if (line)
      this.builder.add(
        layer,
        line.points.map((point) => mapped(place, point)),
        line.closed,
        record.line,
      );
    else this.builder.skip(record.type);
  }

  private insert(record: DxfRecord, place: Affine, layer: string, depth: number): void {
    const name = textIn(record, 2, ""),
      block = this.blocks.get(name);
    if (!block) return this.builder.skip("INSERT");
    if (depth >= DEEPEST) throw new SitePlanError(rule`blocks must be at most ${DEEPEST} deep`, record.line);
    const columns = numberIn(record, 70, 1),
      rows = numberIn(record, 71, 1);
    this.inserts += Math.max(1, columns * rows);
    if (columns * rows > MOST_COPIES || this.inserts > MOST_INSERTS)
      throw new SitePlanError(rule`blocks must be placed at most ${MOST_INSERTS} times`, record.line);
    const turn = radians(numberIn(record, 50, 0)),
      scale = [numberIn(record, 41, 1), numberIn(record, 42, 1)] as const,
      [x, y] = pointIn(record, 10);
    const turned: Affine = [Math.cos(turn), Math.sin(turn), -Math.sin(turn), Math.cos(turn), x, y];
    for (let row = 0; row < rows; row++)
      for (let column = 0; column < columns; column++) {
        const copy: Affine = [1, 0, 0, 1, column * numberIn(record, 44, 0), row * numberIn(record, 45, 0)];
        const sized: Affine = [scale[0], 0, 0, scale[1], -block.base[0] * scale[0], -block.base[1] * scale[1]];
        this.draw(block.entities, after(place, after(turned, after(copy, sized))), layer, depth + 1);
      }
  }
}

/** One entity as a line; null for kinds that are none. */
function lineOf(record: DxfRecord): SitePlanLine | null {
  switch (record.type) {
    case "LINE":
      return { points: [pointIn(record, 10), pointIn(record, 11)], closed: false };
    case "LWPOLYLINE":
      return lightPolyline(record);
    case "CIRCLE":
      return { points: circleArc(pointIn(record, 10), numberIn(record, 40), 0, TAU), closed: true };
    case "ARC": {
      const from = radians(numberIn(record, 50)),
        sweep = (((radians(numberIn(record, 51)) - from) % TAU) + TAU) % TAU;
      return { points: circleArc(pointIn(record, 10), numberIn(record, 40), from, sweep || TAU), closed: false };
    }
    case "ELLIPSE":
      return ellipse(record);
    case "SPLINE": {
      const knots = record.groups.filter(({ code }) => code === 40).map(numberOf),
        fits = pointsIn(record, 11),
        points = spline(numberIn(record, 71, 3), knots, pointsIn(record, 10)) ?? (fits.length > 1 ? fits : null);
      return points && { points, closed: (numberIn(record, 70, 0) & 1) === 1 };
    }
    case "SOLID":
    case "TRACE": {
      const [a, b, c, d] = [10, 11, 12, 13].map((code) => pointIn(record, code));
      return { points: [a!, b!, d!, c!], closed: true };
    }
    default:
      return null;
  }
}

function ellipse(record: DxfRecord): SitePlanLine {
  const [mx, my] = pointIn(record, 11),
    ratio = numberIn(record, 40),
    from = numberIn(record, 41, 0),
    sweep = numberIn(record, 42, TAU) - from;
  const isWhole = Math.abs(Math.abs(sweep) - TAU) < 1e-6,
    over = isWhole ? TAU : ((sweep % TAU) + TAU) % TAU;
  return {
    points: ellipseArc(pointIn(record, 10), [mx, my], [-my * ratio, mx * ratio], from, over),
    closed: isWhole,
  };
}

function lightPolyline(record: DxfRecord): SitePlanLine {
  const corners: { at: Point; bulge: number }[] = [];
  let x: number | null = null;
  for (const group of record.groups) {
    if (group.code === 10) x = numberOf(group);
    else if (group.code === 20) {
      if (x === null) throw new SitePlanError(rule`LWPOLYLINE must have as many y as x`, group.line);
      corners.push({ at: [x, numberOf(group)], bulge: 0 });
      x = null;
    } else if (group.code === 42 && corners.length > 0) lastIn(corners).bulge = numberOf(group);
  }
  if (x !== null) throw new SitePlanError(rule`LWPOLYLINE must have as many y as x`, record.line);
  return withBulges(corners, (numberIn(record, 70, 0) & 1) === 1);
}

function oldPolyline(record: DxfRecord, vertices: readonly DxfRecord[]): SitePlanLine | null {
  const flags = numberIn(record, 70, 0);
  // Meshes are surfaces.
  if (flags & (16 | 64)) return null;
  // Control points of a curve's frame stand among its points.
  const drawn = vertices.filter((vertex) => (numberIn(vertex, 70, 0) & 16) === 0);
  return withBulges(
    drawn.map((vertex) => ({ at: pointIn(vertex, 10), bulge: numberIn(vertex, 42, 0) })),
    (flags & 1) === 1,
  );
}

function withBulges(corners: readonly { at: Point; bulge: number }[], closed: boolean): SitePlanLine {
  const points: Point[] = corners.length > 0 ? [nth(corners, 0).at] : [];
  for (let i = 0; i < corners.length - (closed ? 0 : 1); i++)
    points.push(...bulged(nth(corners, i).at, nth(corners, (i + 1) % corners.length).at, nth(corners, i).bulge));
  return { points, closed };
}
