/**
 * GeoJSON in degrees of WGS 84 or in metres; the layer of a feature is its property `layer`, or the tag that says what
 * it is.
 */
import type { SitePlan, SitePlanLine } from "parkade/siteplan";
import { boxOf, type Point } from "../scene/geometry";
import { circleArc } from "./curves";
import { areDegrees, localProjection } from "./projection";
import { PlanBuilder, SitePlanError } from "./site-plan";
import { nth } from "../scene/nth";
import { rule } from "../i18n/rule";

/** Properties that name a layer, in the spelling of drawing programs. */
const NAMING = ["layer", "Layer", "class", "kind"];
/** Properties by which other programs tell what a feature is; they count where nothing else does. */
const TYPING = ["feature_type", "featuretype", "fclass", "type"];
/** What a relation of OpenStreetMap has as its type says nothing of the thing. */
const UNTOLD = /^(n\/?a|none|null|unknown|no|multipolygon|boundary|node|way|relation|-)?$/i;
/** Tags that say what a thing is, the first that a feature has counts. */
const TELLING = ["amenity", "building", "barrier", "parking", "highway", "landuse", "natural", "area:highway"];
/** Radius of what is given as a point, metres. */
const POINT_RADIUS = 0.15;
const MOST_DEEP = 12;

export type Tags = Readonly<Record<string, unknown>>;

/** `kind=value` of the telling tag, else the feature's type; `otherwise` where there is none. */
export function layerOf(tags: Tags, otherwise: string): string {
  const told = (key: string): string | undefined => {
    const value = tags[key];
    return typeof value === "string" && !UNTOLD.test(value) ? value : undefined;
  };
  const own = NAMING.map(told).find((value) => value !== undefined);
  // Extracts of OpenStreetMap number storeys in `layer`.
  if (own !== undefined && !/^-?\d+$/.test(own)) return own;
  const key = TELLING.find((one) => told(one) !== undefined);
  return key ? `${key}=${told(key)}` : (TYPING.map(told).find((value) => value !== undefined) ?? otherwise);
}

interface Drawn extends SitePlanLine {
  layer: string;
  isPoint: boolean;
}

export function readGeoJson(text: string): SitePlan {
  const drawn: Drawn[] = [];
  walk(parsed(text), "$", {}, drawn, 0);
  return projected(drawn, "geojson", new PlanBuilder());
}

/** Lines in degrees or metres as a plan in metres. */
export function projected(drawn: readonly Drawn[], kind: "geojson" | "osm", builder: PlanBuilder): SitePlan {
  const lines = drawn.map(({ points }) => points),
    box = boxOf(lines.flat()),
    isGlobe = kind === "osm" || areDegrees(lines),
    place = isGlobe ? localProjection([(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2]) : (point: Point) => point;
  for (const { layer, points, closed, isPoint } of drawn) {
    const placed = points.map(place);
    builder.add(layer, isPoint ? circleArc(nth(placed, 0), POINT_RADIUS, 0, 2 * Math.PI) : placed, closed);
  }
  return builder.build(kind, 1);
}

export function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new SitePlanError(rule`must be JSON: ${error instanceof Error ? error.message : String(error)}`);
  }
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

function walk(value: unknown, path: string, tags: Tags, drawn: Drawn[], depth: number): void {
  if (!isObject(value)) throw new SitePlanError(rule`${path}: must be a GeoJSON object`);
  if (depth > MOST_DEEP) throw new SitePlanError(rule`${path}: must be at most ${MOST_DEEP} objects deep`);
  const each = (key: string, own: Tags = tags): void => {
    const list = value[key];
    if (!Array.isArray(list)) throw new SitePlanError(rule`${path}.${key}: must be a list`);
    list.forEach((one, i) => walk(one, `${path}.${key}[${i}]`, own, drawn, depth + 1));
  };
  switch (value["type"]) {
    case "FeatureCollection":
      return each("features");
    case "Feature":
      // A feature may have no place.
      if (value["geometry"] === null) return;
      return walk(
        value["geometry"],
        `${path}.geometry`,
        isObject(value["properties"]) ? value["properties"] : {},
        drawn,
        depth + 1,
      );
    case "GeometryCollection":
      return each("geometries");
    default:
      return geometry(value, path, tags, drawn);
  }
}

function geometry(value: Record<string, unknown>, path: string, tags: Tags, drawn: Drawn[]): void {
  const kind = String(value["type"]),
    at = `${path}.coordinates`,
    layer = layerOf(tags, kind);
  const put = (points: Point[], closed: boolean, isPoint = false): void => {
    drawn.push({ layer, points, closed, isPoint });
  };
  const coordinates = value["coordinates"];
  switch (kind) {
    case "Point":
      return put([position(coordinates, at)], true, true);
    case "MultiPoint":
      return listOf(coordinates, at).forEach((one, i) => put([position(one, `${at}[${i}]`)], true, true));
    case "LineString":
      return put(positions(coordinates, at), false);
    case "MultiLineString":
      return listOf(coordinates, at).forEach((one, i) => put(positions(one, `${at}[${i}]`), false));
    case "Polygon":
      return listOf(coordinates, at).forEach((one, i) => put(positions(one, `${at}[${i}]`), true));
    case "MultiPolygon":
      return listOf(coordinates, at).forEach((rings, i) =>
        listOf(rings, `${at}[${i}]`).forEach((one, j) => put(positions(one, `${at}[${i}][${j}]`), true)),
      );
    default:
      throw new SitePlanError(
        rule`${path}.type: must be a kind of GeoJSON, got ${JSON.stringify(value["type"])?.slice(0, 40)}`,
      );
  }
}

function listOf(value: unknown, path: string): unknown[] {
  if (!Array.isArray(value)) throw new SitePlanError(rule`${path}: must be a list`);
  return value;
}

const positions = (value: unknown, path: string): Point[] =>
  listOf(value, path).map((one, i) => position(one, `${path}[${i}]`));

function position(value: unknown, path: string): Point {
  const [x, y] = Array.isArray(value) ? value : [];
  if (typeof x !== "number" || typeof y !== "number" || !Number.isFinite(x) || !Number.isFinite(y))
    throw new SitePlanError(rule`${path}: must be two numbers`);
  return [x, y];
}
