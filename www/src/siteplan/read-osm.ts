/**
 * OpenStreetMap: `.osm` XML, or the JSON of its query service. Ways and multipolygons with a telling tag, by that tag.
 */
import type { SitePlan } from "parkade/siteplan";
import type { Point } from "../scene/geometry";
import { layerOf, parsed, projected } from "./read-geojson";
import { PlanBuilder, SitePlanError } from "./site-plan";
import { readXml } from "./xml";
import { nth } from "../scene/nth";
import { fieldsOf } from "../scene/records";
import { rule } from "../i18n/rule";

type Tags = Record<string, string>;
interface Way {
  refs: string[];
  tags: Tags;
}
interface Relation {
  members: { type: string; ref: string }[];
  tags: Tags;
}
interface Extract {
  nodes: Map<string, { at: Point; tags: Tags }>;
  ways: Map<string, Way>;
  relations: Relation[];
}

/** A quarter of this is a town. */
const MOST_NODES = 1_000_000;
/** Ways that nobody drives against, and areas that are no edge of anything. */
const IGNORED = /^(highway|landuse)=|^amenity=(?!parking)/;

export function readOsm(text: string): SitePlan {
  return planOf(text.trimStart().startsWith("{") ? fromJson(text) : fromXml(text));
}

function planOf({ nodes, ways, relations }: Extract): SitePlan {
  const builder = new PlanBuilder(),
    drawn: Parameters<typeof projected>[0][number][] = [];
  const put = (tags: Tags, points: Point[], closed: boolean, isPoint = false): void => {
    const layer = layerOf(tags, "");
    if (layer === "") return;
    if (IGNORED.test(layer)) builder.skip(layer);
    else drawn.push({ layer, points, closed, isPoint });
  };
  const pointsOf = (refs: readonly string[]): Point[] =>
    // Extracts are cut at their border: nodes beyond are missing.
    refs.flatMap((ref) => (nodes.has(ref) ? [nodes.get(ref)!.at] : []));
  for (const { refs, tags } of ways.values()) put(tags, pointsOf(refs), refs.length > 3 && refs[0] === refs.at(-1));
  for (const { tags, members } of relations) {
    const outlines = members.flatMap(({ type, ref }) => (type === "way" && ways.has(ref) ? [ways.get(ref)!.refs] : []));
    for (const ring of ringsOf(outlines)) put(tags, pointsOf(ring), ring[0] === ring.at(-1));
  }
  for (const { at, tags } of nodes.values())
    if (tags["barrier"] || tags["natural"] === "tree") put(tags, [at], true, true);
  return projected(drawn, "osm", builder);
}

/** Ways joined at common ends. */
function ringsOf(ways: readonly string[][]): string[][] {
  const open = ways.filter((way) => way.length > 1).map((way) => [...way]),
    rings: string[][] = [];
  while (open.length > 0) {
    const ring = open.shift()!;
    for (let i = 0; ring[0] !== ring.at(-1) && i < open.length; ) {
      const next = nth(open, i);
      if (next[0] === ring.at(-1)) ring.push(...next.slice(1));
      else if (next.at(-1) === ring.at(-1)) ring.push(...next.reverse().slice(1));
      else {
        i++;
        continue;
      }
      open.splice(i, 1);
      i = 0;
    }
    rings.push(ring);
  }
  return rings;
}

function fromXml(text: string): Extract {
  const extract: Extract = { nodes: new Map(), ways: new Map(), relations: [] };
  let tags: Tags = {},
    way: Way | null = null,
    relation: Relation | null = null,
    isOsm = false;
  readXml(text, {
    open: (name, attribute, line) => {
      if (name === "osm") isOsm = true;
      else if (name === "node") {
        tags = {};
        addNode(extract, needed(attribute, "id", name, line), attribute("lon"), attribute("lat"), tags, line);
      } else if (name === "way") {
        way = { refs: [], tags: (tags = {}) };
        extract.ways.set(needed(attribute, "id", name, line), way);
      } else if (name === "relation") extract.relations.push((relation = { members: [], tags: (tags = {}) }));
      else if (name === "nd") way?.refs.push(needed(attribute, "ref", name, line));
      else if (name === "member")
        relation?.members.push({
          type: attribute("type") ?? "",
          ref: needed(attribute, "ref", name, line),
        });
      else if (name === "tag") tags[needed(attribute, "k", name, line)] = needed(attribute, "v", name, line);
    },
    close: () => {},
  });
  if (!isOsm) throw new SitePlanError(rule`the file must hold <osm>`);
  return extract;
}

function needed(attribute: (name: string) => string | undefined, name: string, of: string, line?: number): string {
  const value = attribute(name);
  if (value === undefined) throw new SitePlanError(rule`<${of}> must have the attribute ${name}`, line);
  return value;
}

function addNode({ nodes }: Extract, id: string, lon: unknown, lat: unknown, tags: Tags, line?: number): void {
  // Deleted nodes have no place.
  if (lon === undefined && lat === undefined) return;
  const degrees = (value: unknown): number => (value === "" ? Number.NaN : Number(value)),
    [x, y] = [degrees(lon), degrees(lat)];
  if (!(Math.abs(x) <= 180 && Math.abs(y) <= 90))
    throw new SitePlanError(rule`node ${id}: lon and lat must be degrees, got ${String(lon)} and ${String(lat)}`, line);
  nodes.set(id, { at: [x, y], tags });
  if (nodes.size > MOST_NODES) throw new SitePlanError(rule`an extract must have at most ${MOST_NODES} nodes`, line);
}

function fromJson(text: string): Extract {
  const extract: Extract = { nodes: new Map(), ways: new Map(), relations: [] },
    whole = fieldsOf(parsed(text));
  if (!Array.isArray(whole["elements"])) throw new SitePlanError(rule`elements: must be a list`);
  whole["elements"].forEach((one: unknown, i) => {
    const { type, id, lon, lat, nodes, members, tags } = fieldsOf(one),
      own = Object.fromEntries(Object.entries(Object(tags)).map(([key, value]) => [key, String(value)]));
    if (type === "node") addNode(extract, String(id), lon, lat, own);
    else if (type === "way") {
      if (!Array.isArray(nodes)) throw new SitePlanError(rule`elements[${i}].nodes: must be a list`);
      extract.ways.set(String(id), { refs: nodes.map(String), tags: own });
    } else if (type === "relation") {
      if (!Array.isArray(members)) throw new SitePlanError(rule`elements[${i}].members: must be a list`);
      const read = members.map((member: unknown) => {
        const { type: kind, ref } = fieldsOf(member);
        return { type: String(kind), ref: String(ref) };
      });
      extract.relations.push({ members: read, tags: own });
    }
  });
  return extract;
}
