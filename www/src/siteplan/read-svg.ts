/** SVG: lines, shapes and paths; a layer is the nearest group with a name. */
import type { SitePlan } from "parkade/siteplan";
import svgpath from "svgpath";
import type { Point } from "../scene/geometry";
import { bezier } from "./curves";
import { PlanBuilder, SitePlanError } from "./site-plan";
import { readXml } from "./xml";
import { rule } from "../i18n/rule";

type Attribute = (name: string) => string | undefined;

interface Group {
  layer: string;
  transform: string;
  isHidden: boolean;
}

const HIDDEN = /^(defs|symbol|clipPath|mask|pattern|marker|linearGradient|radialGradient)$/;
const LEFT_OUT = /^(use|image|text|foreignObject)$/;
/** Millimetres of what lengths are given in. */
const MILLIMETRES: Record<string, number> = { mm: 1, cm: 10, in: 25.4, pt: 25.4 / 72, pc: 25.4 / 6, m: 1000 };

export function readSvg(text: string): SitePlan {
  const builder = new PlanBuilder(),
    groups: Group[] = [];
  let isSvg = false,
    unit: number | null = null;
  readXml(text, {
    open: (tag, attribute, line) => {
      const name = tag.replace(/^svg:/, ""),
        above = groups.at(-1) ?? { layer: "SVG", transform: "", isHidden: false };
      if (groups.length === 0) {
        isSvg = name === "svg";
        unit = unitOf(attribute);
      }
      const group = below(above, name, attribute);
      groups.push(group);
      if (group.isHidden) return;
      if (LEFT_OUT.test(name)) builder.skip(`<${name}>`);
      const path = pathOf(name, attribute, line);
      if (path !== null)
        for (const [points, closed] of linesOf(path, group.transform, line))
          builder.add(group.layer, points, closed, line);
    },
    close: () => groups.pop(),
  });
  if (!isSvg) throw new SitePlanError(rule`the file must hold <svg>`);
  return builder.build("svg", unit);
}

function below(above: Group, name: string, attribute: Attribute): Group {
  const isGroup = name === "g" || name === "svg",
    own = isGroup ? (attribute("inkscape:label") ?? attribute("id") ?? attribute("class")) : undefined;
  const style = attribute("style") ?? "";
  return {
    layer: name === "g" && own ? own : above.layer,
    transform: `${above.transform} ${attribute("transform") ?? ""}`.trim(),
    isHidden:
      above.isHidden || HIDDEN.test(name) || attribute("display") === "none" || /display\s*:\s*none/.test(style),
  };
}

/**
 * Metres of paper per unit, where width and view box say it in millimetres and the like; the drawing's scale is not in
 * the file.
 */
function unitOf(attribute: Attribute): number | null {
  const [, size, unit] = /^\s*([\d.]+)\s*([a-z]+)\s*$/.exec(attribute("width") ?? "") ?? [],
    across = Number((attribute("viewBox") ?? "").trim().split(/[\s,]+/)[2]),
    millimetres = MILLIMETRES[unit ?? ""];
  return millimetres && Number(size) > 0 && across > 0 && unit === "m" ? Number(size) / across : null;
}

/** What an element draws as a path's data; null where it draws nothing. */
function pathOf(name: string, attribute: Attribute, line: number): string | null {
  const value = (key: string, otherwise = 0): number => {
    const text = attribute(key);
    if (text === undefined) return otherwise;
    const read = Number(text.trim().replace(/px$/, "") || Number.NaN);
    if (!Number.isFinite(read))
      throw new SitePlanError(rule`<${name}> ${key} must be a number, got ${JSON.stringify(text.slice(0, 40))}`, line);
    return read;
  };
  switch (name) {
    case "path":
      return attribute("d") ?? "";
    case "line":
      return `M${value("x1")} ${value("y1")}L${value("x2")} ${value("y2")}`;
    case "polyline":
    case "polygon":
      return pointsPath(attribute("points") ?? "", name, line);
    case "rect": {
      const [x, y, w, h] = [value("x"), value("y"), value("width"), value("height")];
      return w > 0 && h > 0 ? `M${x} ${y}h${w}v${h}h${-w}z` : null;
    }
    case "circle":
    case "ellipse": {
      const rx = value(name === "circle" ? "r" : "rx"),
        ry = name === "circle" ? rx : value("ry");
      return rx > 0 && ry > 0
        ? `M${value("cx") - rx} ${value("cy")}a${rx} ${ry} 0 1 0 ${2 * rx} 0a${rx} ${ry} 0 1 0 ${-2 * rx} 0z`
        : null;
    }
    default:
      return null;
  }
}

function pointsPath(text: string, name: string, line: number): string | null {
  const numbers = text
    .trim()
    .split(/[\s,]+/)
    .filter(Boolean);
  if (numbers.length % 2 === 1 || numbers.some((one) => !Number.isFinite(Number(one))))
    throw new SitePlanError(rule`<${name}> points must be pairs of numbers`, line);
  return numbers.length < 4 ? null : `M${numbers.join(" ")}${name === "polygon" ? "z" : ""}`;
}

/** Lines of a path, y up. */
function linesOf(data: string, transform: string, line: number): [Point[], boolean][] {
  const path = svgpath(data);
  const { err } = path as unknown as { err?: string };
  if (err) throw new SitePlanError(rule`a path must be drawable: ${err}`, line);
  const lines: [Point[], boolean][] = [];
  let points: Point[] = [];
  const end = (closed: boolean): void => {
    if (points.length > 1) lines.push([points, closed]);
    points = [];
  };
  path
    .transform(transform)
    .abs()
    .unshort()
    .unarc()
    .iterate(([command, ...values], _, x, y) => {
      const at = (k: number): Point => [Number(values[k]), -Number(values[k + 1])],
        now: Point = [x, -y];
      if (points.length === 0 && command !== "M") points.push(now);
      if (command === "M") {
        end(false);
        points.push(at(0));
      } else if (command === "L") points.push(at(0));
      else if (command === "H") points.push([Number(values[0]), -y]);
      else if (command === "V") points.push([x, -Number(values[0])]);
      else if (command === "C") points.push(...bezier(now, at(0), at(2), at(4)));
      else if (command === "Q") points.push(...bezier(now, between(now, at(0)), between(at(2), at(0)), at(2)));
      else if (command === "Z") end(true);
    });
  end(false);
  return lines;
}

/** Two thirds of the way: the control points of a quadratic curve as a cubic one. */
const between = (from: Point, to: Point): Point => [
  from[0] + ((to[0] - from[0]) * 2) / 3,
  from[1] + ((to[1] - from[1]) * 2) / 3,
];
