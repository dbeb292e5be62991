/** A site plan from a file of any kind that can be read, by its name and its contents. */
import type { SitePlan } from "parkade/siteplan";
import { readDxf } from "./read-dxf";
import { readGeoJson } from "./read-geojson";
import { readOsm } from "./read-osm";
import { readSvg } from "./read-svg";
import { MOST_BYTES, SitePlanError, type SitePlanKind } from "./site-plan";
import { rule } from "../i18n/rule";

const READERS: Record<SitePlanKind, (text: string) => SitePlan> = {
  dxf: readDxf,
  svg: readSvg,
  geojson: readGeoJson,
  osm: readOsm,
};

/** Throws `SitePlanError` where the file is none. */
export function readSitePlan(name: string, content: string | Uint8Array): SitePlan {
  if (content.length > MOST_BYTES)
    throw new SitePlanError(
      rule`a site plan must have at most ${MOST_BYTES / 1e6} MB, got ${Math.ceil(content.length / 1e6)} MB`,
    );
  const text = (typeof content === "string" ? content : new TextDecoder().decode(content)).replace(/^\uFEFF/, "");
  return READERS[kindOf(name, text)](text);
}

/** Undefined where a name does not say it. */
export function sitePlanKind(name: string): SitePlanKind | undefined {
  const [, end] = /\.(\w+)$/.exec(name.toLowerCase()) ?? [];
  return end === "dxf" || end === "svg" || end === "osm" || end === "geojson" ? end : end === "dwg" ? "dxf" : undefined;
}

function kindOf(name: string, text: string): SitePlanKind {
  const head = text.slice(0, 2000).trimStart(),
    told = sitePlanKind(name);
  if (head.startsWith("{")) return /"elements"\s*:/.test(head) ? "osm" : "geojson";
  if (told) return told;
  if (head.startsWith("<")) return /<osm\b/.test(head) ? "osm" : "svg";
  return "dxf";
}
