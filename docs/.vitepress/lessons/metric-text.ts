/** The controls and numbers of a figure with cars, as HTML. */
import { escaped } from "./grid-text";
import { curveOf, curvatureOf, type MetricState } from "./metric-state";
import { said, word, type Lang } from "./words";

export function metricControls(state: MetricState, lang: Lang): string {
  const { choices = [], sliders = [] } = state.figure;
  const buttons =
    choices.length > 1
      ? `<span class="lab-choices">${choices
          .map(
            ({ key, title }) =>
              `<button type="button" ` +
              `data-choice="${key}" aria-pressed="${key === state.chosen}">${escaped(said(title, lang))}</button>`,
          )
          .join("")}</span>`
      : "";
  const labels = sliders.map(
    ({ setting, min, max, step, title }) =>
      `<label>${escaped(said(title, lang))} <input type="range" ` +
      `data-value="${setting}" min="${min}" max="${max}" step="${step}" value="${state.values[setting]}"> ` +
      `<output>${state.values[setting]}</output></label>`,
  );
  return `${buttons}${labels.join("")}<button type="button" data-reset>${word("reset", lang)}</button>`;
}

const number = (value: number): string => value.toFixed(2);

export function metricReadout(state: MetricState, lang: Lang): string {
  return [...planLines(state, lang), ...ownLines(state, lang)].map((line) => `<span>${line}</span>`).join("");
}

function planLines({ figure, plans, chosen }: MetricState, lang: Lang): string[] {
  return (figure.choices ?? []).map(({ key, title }) => {
    const plan = plans[key];
    if (!plan) return "";
    const name = `<b>${escaped(said(title, lang))}</b>`;
    if (plan.outcome !== "found") return `${name} ${word("noPath", lang)}`;
    const { length, directionChanges, minClearance } = plan.metrics;
    const line = `${name} ${word(
      "driven",
      lang,
      number(length),
      directionChanges,
    )} · ${word("clearance", lang, number(minClearance))} · ${word("poses", lang, plan.stats.expanded)}`;
    return key === chosen ? `<i class="lab-chosen">${line}</i>` : line;
  });
}

function ownLines(state: MetricState, lang: Lang): string[] {
  const { check, figure, hits } = state;
  if (figure.drives && hits !== null) return [word("drives", lang, hits, figure.drives)];
  if (figure.shows === "curves") {
    const curve = curveOf(state);
    if (!curve) return [];
    return [
      `${word(
        "curve",
        lang,
        state.curves.indexOf(curve) + 1,
        state.curves.length,
      )} <b>${curve.word}</b> · ${word("driven", lang, number(curve.length), curve.directionChanges)}`,
    ];
  }
  if (!check) return [];
  const least = Math.min(...check.clearances);
  const touch = check.hits > 0 ? word("overlaps", lang) : word("clearance", lang, number(least));
  if (figure.shows !== "arc") return [touch];
  const curvature = curvatureOf(state);
  const radius = Math.abs(curvature) < 1e-6 ? "∞" : number(1 / Math.abs(curvature));
  return [`${word("radius", lang, radius)} · ${touch}`];
}
