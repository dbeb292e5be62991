/** A recorded search as data: its size, whether it counts what its planner counted, its files. */
import { html, nothing, type TemplateResult } from "lit";
import { download } from "../app/app";
import { number, type Lang } from "../i18n/index";
import { traceAsJson, traceForPosthoc } from "../planning/trace-export";
import type { State } from "../store";
import { say } from "../texts/search-messages";
import { samplingOf } from "../texts/sampling-steps";
import type { Session } from "./debugger-session";

const STEP_BYTES = 33,
  MOVE_BYTES = 21,
  POSE_BYTES = 44,
  MOVES_A_STEP = 16;

/** What a search of so many steps is likely to take. */
export const bytesOf = (steps: number): number => steps * (STEP_BYTES + MOVES_A_STEP * MOVE_BYTES);

export function saveButtons(lang: Lang, { planner, replay }: Session): TemplateResult {
  const { trace } = replay,
    isPosthoc = trace.kind === "search" && samplingOf(replay) !== "candidates";
  const save = (text: string, ending: string): void =>
    download(new Blob([text], { type: "application/json" }), `${planner}-search${ending}`);
  return html`<button class="button outline" @click=${() =>
    save(traceAsJson(planner, trace), ".json")}>${say(lang, "export.json")}</button>
    ${
      isPosthoc
        ? html`<button class="button outline" @click=${() =>
            save(traceForPosthoc(trace), ".trace.json")}>${say(lang, "export.posthoc")}</button>`
        : nothing
    }`;
}

/** The size of the recording, and whether its counters are those of the plan. */
export function recordingNote({ lang, results }: State, { planner, replay: { trace } }: Session): string {
  const { counters } = trace,
    stats = results[planner]?.plan?.stats,
    steps = trace.nodes.length,
    moves = trace.targets.length;
  const bytes = steps * STEP_BYTES + moves * (trace.kind === "poses" ? MOVE_BYTES + POSE_BYTES : MOVE_BYTES);
  const size = say(lang, "size", { steps, moves, mb: number(lang, bytes / 1e6, 1) });
  if (trace.cut) return `${size} ${say(lang, "cut", { n: steps })}`;
  if (stats && counters.expanded < stats.expanded)
    return `${size} ${say(lang, "oneOfSeveral", { expanded: counters.expanded, all: stats.expanded })}`;
  const isEqual =
    stats &&
    counters.expanded === stats.expanded &&
    counters.generated === stats.generated &&
    counters.pushes === stats.pushes &&
    counters.openPeak === stats.openPeak;
  if (!isEqual) return `${size} ${say(lang, "unequal")}`;
  const { expanded, generated, pushes, openPeak: peak } = counters;
  return `${size} ${say(lang, "equal", { expanded, generated, pushes, peak })}`;
}
