/** Reverse gear and gear changes on the timeline. */
import { html, nothing, svg, type TemplateResult } from "lit";
import type { State } from "../store";
import { gearsOfTimeline } from "../view/gears";

export function gearMarks(state: State): TemplateResult | typeof nothing {
  const gears = gearsOfTimeline(state);
  if (!gears) return nothing;
  return html`<svg class="rails" aria-hidden="true">${gears.reverse.map(
    ([from, to]) => svg`<line class="reverse" x1="${from * 100}%" x2="${to * 100}%" y1="22" y2="22"/>`,
  )}</svg>
    ${gears.changes.map(
      (at) =>
        html`<svg class="diamond" .style=${`transform:translateX(${at * 100}cqw)`} viewBox="0 0 10 10"
          aria-hidden="true"><path d="M5 0l5 5-5 5-5-5z"/></svg>`,
    )}`;
}
