/** Everything that the papers' pages hold, measured once. */
import type { PaperClaim, PaperTable, ParkingTable, RoadTable, VolumeComparison } from "parkade";
import {
  paperGrid,
  paperGridRows,
  paperGridSummary,
  paperParking,
  paperParkingRows,
  paperRoad,
  paperRoadRows,
  paperIncomplete,
  paperVerdicts,
  paperVolumes,
} from "../../../pkg/node.js";
import messages from "../../../www/src/i18n/messages/claims.json";
import { foundText } from "../../../www/src/texts/claims";
import { table, type Block, type Lang } from "./blocks";

export interface Measured {
  seeds: number;
  columns: string[];
  grid: { tables: PaperTable[]; claims: PaperClaim[] };
  incomplete: Record<string, number[]>;
  parking: ParkingTable[];
  road: RoadTable[];
  verdicts: ReturnType<typeof paperVerdicts>;
  volumes: VolumeComparison[];
}

export function measure(seeds: number): Measured {
  const { rows, columns } = paperGridRows(),
    slice = (row: string) => ({ row, from: 1, to: seeds });
  const parking = paperParkingRows().map(({ id }) => paperParking({ row: id })),
    road = paperRoadRows().map(({ id }) => paperRoad({ row: id }));
  return {
    seeds,
    columns,
    parking,
    road,
    grid: paperGridSummary(Object.fromEntries(rows.map(({ id }) => [id, paperGrid(slice(id))]))),
    incomplete: Object.fromEntries(rows.map(({ id }) => [id, paperIncomplete({ row: id, from: 1, to: 200 })])),
    verdicts: paperVerdicts({ parking, road }),
    volumes: ["P0", "park-fig13", "reverse-in"].map((scene) => paperVolumes({ scene, poses: 50_000, rounds: 3 })),
  };
}

export const fixed = (value: number | null | undefined, digits = 2): string =>
  value === null || value === undefined ? "–" : value.toFixed(digits).replace("-", "−");
/** Words of both languages. */
export const words =
  (lang: Lang) =>
  (en: string, zh: string): string =>
    lang === "zh" ? zh : en;

const HOLDS = {
  yes: ["holds", "成立"],
  partly: ["holds in part", "部分成立"],
  no: ["does not hold", "不成立"],
  unknown: ["not judged", "未判定"],
} as const;
type Found = keyof typeof messages;

export function claims(lang: Lang, all: readonly PaperClaim[]): Block {
  const t = words(lang),
    say = (key: string): string => messages[`claim.${key}` as Found][lang === "zh" ? 1 : 0]!;
  // Times are measured by the reader's machine; none stands in a page.
  const timeless = ({ figures, ...claim }: PaperClaim): PaperClaim => ({
    ...claim,
    figures: Object.fromEntries(Object.entries(figures).filter(([name]) => !name.startsWith("time"))),
  });
  const found = (one: PaperClaim): string =>
    foundText(timeless(one), {
      template: say(`${one.id}.found`),
      range: say("range"),
      missing: say("missing"),
      number: (value, digits) => value.toFixed(digits).replace("-", "−"),
    });
  return table(
    [t("claim", "论断"), t("verdict", "判定"), t("found here", "本地结果")],
    all.map((one) => [say(`${one.id}.text`), HOLDS[one.holds][lang === "zh" ? 1 : 0], found(one)]),
  );
}
