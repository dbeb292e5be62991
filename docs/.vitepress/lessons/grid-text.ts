/** The controls and numbers of a grid figure, as HTML. */
import { chosenOf, costOf, expandedOf, type GridState } from "./grid-state";
import { said, word, type Lang } from "./words";

export const escaped = (text: string): string =>
  text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");

const button = (name: string, key: string, label: string, pressed: boolean): string =>
  `<button type="button" data-${name}="${key}" aria-pressed="${pressed}">${escaped(label)}</button>`;

export function controlsOf(state: GridState, lang: Lang): string {
  const { figure } = state;
  const choices =
    figure.choices.length > 1
      ? `<span class="lab-choices">${figure.choices
          .map(({ key, title }) => button("choice", key, said(title, lang), key === state.chosen))
          .join("")}</span>`
      : "";
  const stages =
    figure.view === "stages"
      ? `<span class="lab-choices">${(["raw", "pruned", "arcs"] as const)
          .map((key) => button("stage", key, word(key, lang), key === state.stage))
          .join("")}</span>`
      : "";
  const { slider } = figure;
  const search =
    `<label>${word("search", lang)} <input type="range" data-share min="0" max="1" step="any" ` +
    `value="${state.share}"></label>`;
  const own = slider
    ? `<label>${escaped(said(slider.title, lang))} <input type="range" data-value ` +
      `min="${slider.min}" max="${slider.max}" step="${slider.step}" value="${state.value}"> ` +
      `<output>${state.value}</output></label>`
    : "";
  return (
    `${choices}${stages}${figure.view === "search" ? search : ""}${own}<button type="button" ` +
    `data-reset>${word("reset", lang)}</button>`
  );
}

const number = (value: number): string => value.toFixed(2);

/** A line for each choice, and one for what is picked. */
export function readoutOf(state: GridState, lang: Lang): string {
  const lines = state.figure.choices.map(({ key, title }) => {
    const plan = state.plans[key];
    if (!plan) return "";
    const cost = costOf(plan);
    const length = Number.isFinite(cost) ? word("length", lang, number(cost)) : word("noPath", lang);
    const stages = plan.stages;
    const rest =
      state.figure.view === "stages" && stages
        ? word("corners", lang, stages.pruned.length - 2, stages.arcs.length, stages.sharp.length)
        : word("cells", lang, plan.stats.expanded);
    return `<span${
      key === state.chosen ? ' class="lab-chosen"' : ""
    }><b>${escaped(said(title, lang))}</b> ${rest} · ${length}</span>`;
  });
  if (state.share < 1) {
    const all = expandedOf(state, 1).length;
    lines.push(`<span>${word("of", lang, expandedOf(state).length, all)}</span>`);
  } else if (state.picked !== null) lines.push(`<span>${picked(state, lang)}</span>`);
  return lines.join("");
}

function picked({ picked: cell, map, costs, explanation, figure }: GridState, lang: Lang): string {
  const name = `(${cell! % map.width}, ${map.height - 1 - Math.floor(cell! / map.width)})`;
  if (map.walls[cell!]) return word("wall", lang, name);
  if (figure.view === "force")
    return explanation
      ? `${word("force", lang, ...explanation.force.map(number))} · ${word(
          "region",
          lang,
          explanation.region,
          ARROWS[explanation.center]!,
        )}`
      : "";
  if (!costs) return word("unreachable", lang, name);
  return word("cell", lang, name, number(costs.g), number(costs.h), number(costs.g + costs.h));
}

const ARROWS = ["→", "↗", "↑", "↖", "←", "↙", "↓", "↘"];

export const describedBy = (state: GridState, lang: Lang): string =>
  `${word("grid", lang, state.map.width, state.map.height)} ${said(chosenOf(state).title, lang)}`;
