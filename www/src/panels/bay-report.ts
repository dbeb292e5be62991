import type { AuditRow } from "parkade";
import { download, type App } from "../app/app";
import { number, reasonIn, type Lang } from "../i18n/index";
import { escaped } from "../picture/canvas";
import {
  boxOfDrawing,
  paperFor,
  printPage,
  SCALES,
  sheetSvg,
  type ScaleSheet,
  type SheetArea,
} from "../picture/scale-sheet";
import { siteDrawing } from "../picture/site-drawing";
import { fileName } from "../scene/files";
import { slotOutline } from "../scene/slots";
import type { Scene } from "../store";
import { bestRow, countBays, gradeOf, HARD, type BayCheck } from "../store/bay-check";
import { INK, RAMP } from "../view/layers/bays";
import { BAY_COLUMNS, bayLines } from "./bay-rows";
import { heading, say as sayBays } from "./bay-messages";
import { say, today, vehicleText } from "./sheet-messages";
import { lastIn, nth } from "../scene/nth";
import { sceneTitle } from "../app/scene-title";

export function saveReport(app: App): void {
  const { bays, scene, lang } = app.store.state;
  if (!bays) return;
  const page = reportPage(scene, bays, lang, sceneTitle(app));
  download(new Blob([page], { type: "text/html" }), `${fileName(scene)}-bays.html`);
}

/**
 * The largest usual scale at which the lot fits on A4, otherwise on the paper that it needs. Where no paper is large
 * enough, a sentence says so, and the table stands alone.
 */
export function reportPage(scene: Scene, check: BayCheck, lang: Lang, name = scene.name): string {
  const drawing = siteDrawing(scene, null, { every: 0 }),
    box = boxOfDrawing(drawing),
    scale = SCALES.find((one) => paperFor(box, one) === "A4") ?? SCALES.find((one) => paperFor(box, one)),
    title = name || sayBays(lang, "title"),
    language = lang === "zh" ? "zh-CN" : "en";
  if (scale === undefined) {
    const note = say(lang, "tooLarge", { scale: lastIn(SCALES) });
    return printPage(title, language, { svg: "", paper: "A4" }, tableOf(check, lang, title, note));
  }
  const { asked, reachable, hard } = countBays(check);
  const sheet: ScaleSheet = {
    drawing,
    shown: new Set(["ground", "bays", "obstacles", "parked"]),
    areas: [...check.rows.keys()].flatMap((index) => areaOf(scene, check, index)),
    scale,
    title,
    rows: [
      [say(lang, "scale"), `1:${scale}`],
      [say(lang, "vehicle"), vehicleText(lang, check.vehicle.vehicle)],
      [
        sayBays(lang, "title"),
        `${sayBays(lang, "reachable", { n: reachable, of: asked })} · ${sayBays(lang, "hard", { n: hard })}`,
      ],
      [say(lang, "date"), today(lang)],
      [say(lang, "hash"), hashOf(check)],
    ],
    legend: [
      ...RAMP.light.map((fill, i) => ({
        fill,
        text: i < HARD ? say(lang, "moves", { n: i + 1 }) : say(lang, "more", { n: HARD }),
        isHatched: false,
      })),
      { fill: "#FBECEA", text: sayBays(lang, "outOfReach"), isHatched: true },
    ],
  };
  return printPage(title, language, sheetSvg(sheet), tableOf(check, lang, title));
}

function areaOf(scene: Scene, check: BayCheck, index: number): SheetArea[] {
  const slot = scene.slots?.[index],
    row = bestRow(check, index);
  if (!slot || !row) return [];
  const grade = gradeOf(row);
  return [
    {
      points: slotOutline(slot),
      fill: grade === 0 ? "#FBECEA" : nth(RAMP.light, grade - 1),
      ink: grade === 0 ? "#B3261E" : nth(INK.light, grade - 1),
      text: grade === 0 ? "\u2715" : String(row.moves),
      isHatched: grade === 0,
    },
  ];
}

/** FNV-1a over the hashes of all plans: the same report, the same eight digits. */
export function hashOf(check: BayCheck): string {
  let hash = 0x811c9dc5;
  for (const index of [...check.rows.keys()].sort((a, b) => a - b))
    for (const row of check.rows.get(index)!)
      for (const letter of `${row.bay} ${row.entry} ${row.hash};`)
        hash = Math.imul(hash ^ letter.codePointAt(0)!, 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, "0");
}

function tableOf(check: BayCheck, lang: Lang, title: string, note = ""): string {
  const cell = (text: string): string => `<td>${escaped(text)}</td>`,
    moves = (row: AuditRow | undefined): string =>
      row ? (gradeOf(row) === 0 ? "\u2715" : String(row.moves)) : "\u2013";
  const rows = bayLines(check, { column: "bay", descends: false }).map(({ bay, best, headIn, reverseIn }) => {
    const figures = best.reachable
      ? [
          number(lang, best.length, 1),
          best.driveTime === null ? "\u2013" : number(lang, best.driveTime, 0),
          number(lang, best.clearance, 2),
        ]
          .map(cell)
          .join("")
      : `<td class="text" colspan="3">${escaped(reasonIn(lang, best.reason ?? ""))}</td>`;
    return `<tr>${cell(bay)}${cell(moves(headIn))}${cell(moves(reverseIn))}${figures}</tr>`;
  });
  const head = BAY_COLUMNS.map((column) => `<th>${escaped(heading(lang, column))}</th>`).join("");
  return `<h1>${escaped(title)}</h1>${
    note && `<p>${escaped(note)}</p>`
  }<table><thead><tr>${head}</tr></thead><tbody>${rows.join("")}</tbody></table>`;
}
