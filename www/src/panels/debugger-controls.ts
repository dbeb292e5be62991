/** The controls of a walk through a recorded search. */
import { html, nothing, type TemplateResult } from "lit";
import { number, type Lang } from "../i18n/index";
import { icon, type IconName } from "../styles/icons";
import { placeOf, say } from "../texts/search-messages";
import { chosenOf } from "./chosen";
import { legend, unitsOf } from "./debugger-parts";
import { POSE_RADIUS, SPEEDS, type Breakpoints, type Session } from "./debugger-session";
import { numberOf, valueOf } from "./inputs";

const UNIT_KEYS = {
  step: "unit.step",
  move: "unit.move",
  improved: "unit.improved",
  tie: "unit.tie",
  refused: "unit.refused",
  held: "unit.held",
  failure: "unit.failure",
} as const;

interface Picker {
  isPicking: boolean;
  pick(): void;
  shown(): void;
}

/** The steps forth and back, the unit and the pace of a walk, and the slider over it. */
export function transport(lang: Lang, session: Session, toggled: () => void): TemplateResult {
  const { replay } = session;
  const press = (
    name: IconName,
    key: "first" | "back" | "run" | "pause" | "next" | "last",
    run: () => void,
  ): TemplateResult =>
    html`<button class="icon" aria-label=${say(lang, key)} title=${say(lang, key)}
        @click=${run}>${icon(name)}</button>`;
  return html`<div class="keys-row">
        ${press("first", "first", () => session.seek(0))}${press("back", "back", () => session.move(-1))}
        ${press(session.isRunning ? "pause" : "play", session.isRunning ? "pause" : "run", () => {
          session.toggle();
          toggled();
        })}
        ${press("next", "next", () => session.move(1))}${press("last", "last", () => session.seek(replay.events))}
        <select aria-label=${say(lang, "unit")} title=${say(lang, "unit")} @change=${(e: Event) => {
          session.unit = chosenOf(e, unitsOf(replay));
        }}>${unitsOf(replay).map(
          (unit) =>
            html`<option value=${unit} ?selected=${unit === session.unit}>${say(lang, UNIT_KEYS[unit])}</option>`,
        )}</select>
        <select aria-label=${say(lang, "speed")} title=${say(lang, "speed")} @change=${(e: Event) => {
          session.speed = numberOf(e);
        }}>${SPEEDS.map(
          (speed) => html`<option value=${speed} ?selected=${speed === session.speed}>${speed}/s</option>`,
        )}</select></div>
      <input class="slider" type="range" min="0" max=${replay.events} .value=${String(replay.at)}
        .style=${`--at:${(100 * replay.at) / Math.max(1, replay.events)}%`}
        aria-label=${say(lang, "position", { step: replay.step + 1, steps: replay.steps })}
        @input=${(e: Event) => session.seek(numberOf(e))}>
      <p class="note">${say(lang, "position", { step: replay.step + 1, steps: replay.steps })}</p>
      ${legend(lang, replay)}`;
}

/** Where a run stops; `pick` has the next click on the map choose a place, `shown` draws what has changed. */
export function breakpoints(lang: Lang, session: Session, { isPicking, pick, shown }: Picker): TemplateResult {
  const { breaks, replay } = session;
  const set = (patch: Partial<Breakpoints>): void => {
    session.breaks = { ...breaks, ...patch };
    shown();
  };
  const cells = [...breaks.cells],
    { points } = breaks;
  const chip = (place: string, without: Partial<Breakpoints>): TemplateResult =>
    html`<button class="chip" aria-label=${say(lang, "breaks.remove", { place })}
        @click=${() => set(without)}>${place} ✕</button>`;
  const hasPoses = replay.trace.kind === "poses";
  return html`<h3>${say(lang, "breaks")}</h3>
      <div class="rows"><button class="button outline" aria-pressed=${isPicking}
        @click=${pick}>${say(lang, hasPoses ? "breaks.pose" : "breaks.cell")}</button>
        ${cells.map((node) =>
          chip(placeOf(lang, replay, 0, node), { cells: new Set(cells.filter((one) => one !== node)) }),
        )}
        ${points.map((point) =>
          chip(`(${number(lang, point.x, 2)}, ${number(lang, point.y, 2)})`, {
            points: points.filter((one) => one !== point),
          }),
        )}</div>
      ${
        isPicking
          ? html`<p class="note">${
              hasPoses ? say(lang, "breaks.pickPose", { r: number(lang, POSE_RADIUS, 1) }) : say(lang, "breaks.pick")
            }</p>`
          : nothing
      }
      <label class="check">${say(lang, "breaks.f")}<span class="field"><input inputmode="decimal"
        .value=${breaks.f === null ? "" : String(breaks.f / replay.trace.unit)}
        @change=${(e: Event) =>
          set({
            f: Number.isNaN(numberOf(e)) || valueOf(e) === "" ? null : numberOf(e) * replay.trace.unit,
          })}></span></label>
      <label class="check"><input type="checkbox" .checked=${breaks.improved}
        @change=${() => set({ improved: !breaks.improved })}>${say(lang, "breaks.improved")}</label>
      ${
        replay.sides.length > 1
          ? html`<label class="check"><input type="checkbox" .checked=${breaks.meet}
            @change=${() => set({ meet: !breaks.meet })}>${say(lang, "breaks.meet")}</label>`
          : nothing
      }`;
}
