/** How a car fares among moving obstacles, in a word for its panel. */
import "../i18n/later";
import { number, translate } from "../i18n/index";
import type { PanelResult, State } from "../store";
import { played } from "../store/results";
import { isEncounter } from "../view/playback-time";
import type { Status } from "./status";

const LATE = { unavoidable: "moving.unavoidable", blocked: "moving.blocked", "out-of-time": "moving.late" } as const;

/** Null where nothing moves, and where nothing is worth saying. */
export function encounterOf({ lang }: State, result: PanelResult | undefined): Status | null {
  const drive = played(result)?.drive;
  if (!isEncounter(drive)) return null;
  const waited = drive.waits.reduce((sum, { from, to }) => sum + to - from, 0);
  if (drive.contact) return toned("err", translate(lang, "moving.hit", { s: number(lang, drive.contact.t, 1) }));
  if (drive.ending !== "arrived" && drive.ending !== "hit") return toned("err", translate(lang, LATE[drive.ending]));
  if (waited === 0) return null;
  const status = toned("warn", translate(lang, "moving.waits", { s: number(lang, waited, 1) })),
    least = drive.timesToCollision.reduce((least, time) => Math.min(least, time), Infinity);
  if (least === Infinity) return status;
  return { ...status, title: translate(lang, "moving.nearest", { chip: status.chip, s: number(lang, least, 1) }) };
}

const toned = (tone: Status["tone"], text: string): Status => ({
  tone,
  icon: tone === "err" ? "warning" : "clock",
  chip: text,
  brief: text,
  tiny: text,
});
