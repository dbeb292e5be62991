/** What became of the connection to the other end that a step of a search for a car tried. */
import { html, type TemplateResult } from "lit";
import { number } from "../i18n/index";
import type { FailedExpansion } from "../planning/failed-expansions";
import { STEP, type SearchReplay } from "../planning/search-replay";
import type { State } from "../store";
import { say } from "../texts/search-messages";
import { thingName } from "../texts/status";

export function connectionCard(state: State, replay: SearchReplay, failed: FailedExpansion | null): TemplateResult {
  const { lang } = state,
    kind = replay.step < 0 ? STEP.expand : replay.kindOf(replay.step);
  const text = failed
    ? say(lang, "arcs.failed", {
        thing: obstacleName(state, failed.obstacle),
        length: number(lang, failed.length, 2),
      })
    : kind === STEP.meet
      ? say(lang, "arcs.met")
      : say(lang, kind === STEP.goal || kind === STEP.joined ? "arcs.joined" : "arcs.untried");
  return html`<h3>${say(lang, "arcs.connection")}</h3><p>${text}</p>`;
}

/** The name of an obstacle by its index; below 0 the border and parked cars. */
export function obstacleName(state: State, index: number): string {
  const { lang, scene } = state;
  if (index < 0) return say(lang, "arcs.other");
  return thingName(state, { obstacle: scene.obstacles?.[index]?.id ?? "", index });
}
