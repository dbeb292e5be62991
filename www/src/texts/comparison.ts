/** Words of the road manuscript's comparison and sensitivity, for the page and for documents. */
import type { Lang } from "../i18n/index";
import messages from "../i18n/messages/comparison.json";
import { translator } from "../i18n/translator";
import type { Chart } from "../picture/small-multiples";
import type { Compared, ComparedClaim, Sample, Span, Swept } from "../planning/comparison";
import { MEASURED, SWEPT } from "../planning/comparison";
import { keysOf } from "../scene/records";

export const say = translator("comparison", messages);

const FOUND = { RRT: "RRTFound", Dijkstra: "DijkstraFound", genetic: "geneticFound" } as const;

export const claimOf = (lang: Lang, { id }: ComparedClaim): string => say(lang, id);
export const foundOf = (lang: Lang, { id, found }: ComparedClaim): string => say(lang, FOUND[id], found);

/** A median, and the ends of the range where they differ. */
export function spanText(span: Span | null, digits: number, write: (value: number, digits: number) => string): string {
  if (!span) return "–";
  const [median, least, most] = [write(span[0], digits), write(span[1], digits), write(span[2], digits)];
  return least === most ? median : `${median} (${least}–${most})`;
}

/** The columns of the comparison besides scene and planner. */
export const COLUMNS = ["found", "collide", "length", "turning", "clearance", "hits", "expanded"] as const;

export function cellOf(
  one: Compared,
  column: (typeof COLUMNS)[number],
  write: (value: number, digits: number) => string,
): string {
  switch (column) {
    case "found":
      return one.asked === 1 ? String(one.found) : `${one.found} / ${one.asked}`;
    case "collide":
      return String(one.collide);
    case "length":
      return spanText(one.length, 1, write);
    case "turning":
      return spanText(one.turning, 0, write);
    case "clearance":
      return spanText(one.clearance, 2, write);
    case "hits":
      return one.hits === null ? "–" : String(one.hits);
    case "expanded":
      return spanText(one.expanded, 0, write);
  }
}

/** The default of each setting that is swept. */
const DEFAULTS: Record<Swept, number> = {
  alpha: 0.3,
  beta: 0.5,
  factor: 0.8,
  epsilon: 0.2,
  decay: 1.5,
  margin: 0.8,
  threshold: 0.8,
  resolution: 1,
};

/** A row of charts a setting, a column a figure, a line a scene. */
export function chartsOf(
  lang: Lang,
  sweeps: readonly { swept: Swept; scene: string; samples: readonly Sample[] }[],
): Chart[] {
  return keysOf(SWEPT).flatMap((swept) =>
    MEASURED.map((figure) => ({
      row: say(lang, swept),
      column: say(lang, figure),
      mark: DEFAULTS[swept],
      lines: sweeps
        .filter((one) => one.swept === swept)
        .map(({ scene, samples }) => ({
          name: scene,
          points: samples.map(({ value, figures }) => [value, figures[figure]] as const),
        })),
    })),
  );
}
