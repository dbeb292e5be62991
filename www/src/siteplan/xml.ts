/** XML as a stream of elements; strict, with the line of a mistake. */
import { SaxesParser } from "saxes";
import { SitePlanError } from "./site-plan";
import { rule } from "../i18n/rule";

export interface XmlReader {
  open(name: string, attribute: (name: string) => string | undefined, line: number): void;
  close(name: string): void;
}

/** Characters that are parsed at once. */
const PIECE = 1 << 16;
const MOST_DEEP = 200;

export function readXml(text: string, reader: XmlReader): void {
  const parser = new SaxesParser();
  let depth = 0;
  parser.on("error", (error) => {
    throw new SitePlanError(rule`must be XML: ${error.message.replace(/^\d+:\d+: /, "")}`, parser.line);
  });
  parser.on("opentag", ({ name, attributes }) => {
    if (++depth > MOST_DEEP) throw new SitePlanError(rule`elements must be at most ${MOST_DEEP} deep`, parser.line);
    const values = attributes as Record<string, string>;
    reader.open(name, (key) => (Object.hasOwn(values, key) ? values[key] : undefined), parser.line);
  });
  parser.on("closetag", ({ name }) => {
    depth--;
    reader.close(name);
  });
  for (let at = 0; at < text.length; at += PIECE) parser.write(text.slice(at, at + PIECE));
  parser.close();
}
