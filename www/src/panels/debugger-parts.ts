import { html, nothing, type TemplateResult } from "lit";
import type { Explanation } from "parkade";
import { number, type Lang } from "../i18n/index";
import type { SearchReplay } from "../planning/search-replay";
import { estimatesAt, fateText, pseudocode } from "../texts/search-steps";
import { cost, placeOf, placeOfStep, say, targetOf } from "../texts/search-messages";
import { samplingOf } from "../texts/sampling-steps";
import { UNITS, type Unit } from "./debugger-session";
import { SIGNS } from "../view/layers/search-marks";
import { nth } from "../scene/nth";
import { keysOf } from "../scene/records";

const SHOWN_ENTRIES = 12;

/** The moves of the step at hand, as far as they have been considered. */
export function movesTable(lang: Lang, replay: SearchReplay): TemplateResult | typeof nothing {
  const { step, move, trace } = replay;
  if (step < 0) return nothing;
  const moves: number[] = [];
  for (let one = nth(trace.first, step); one <= move; one++) moves.push(one);
  return html`<h3>${say(lang, samplingOf(replay) === "candidates" ? "legs" : "moves", {
    place: placeOfStep(lang, replay, step),
  })}</h3>
    ${
      trace.first[step] === trace.first[step + 1]
        ? html`<p class="note">${say(lang, "moves.none")}</p>`
        : html`<table><thead><tr><th></th><th>${say(lang, "to")}</th><th class="number">g</th><th
          class="number">h</th><th>${say(lang, "fate")}</th></tr></thead>
    <tbody>${moves.map((one) => moveRow(lang, replay, one))}</tbody></table>`
    }`;
}

function moveRow(lang: Lang, replay: SearchReplay, move: number): TemplateResult {
  const { trace } = replay,
    fate = replay.fateOf(move);
  const isLegal = fate !== "blocked" && fate !== "corner",
    hasG = isLegal && !(fate === "drawn" && samplingOf(replay) === "tree"),
    hasH = fate === "kept" || fate === "improved";
  return html`<tr class="${move === replay.move ? "now" : ""} ${isLegal ? "" : "bad"}"><td class="sign"
    aria-hidden="true">${SIGNS[fate]}</td><td>${targetOf(lang, replay, move)}</td>
    <td class="number">${hasG ? cost(lang, replay, nth(trace.targetG, move)) : ""}</td><td class="number">${
      hasH ? cost(lang, replay, nth(trace.targetH, move)) : ""
    }</td><td>${fateText(lang, replay, move)}</td></tr>`;
}

/** The entries that come next on a side. */
export function openTable(lang: Lang, replay: SearchReplay, side: number): TemplateResult {
  const sampling = samplingOf(replay);
  if (sampling)
    return sampling === "tree"
      ? html`<h3>${say(lang, "tree", { n: nth(replay.sides, side).open.length })}</h3>`
      : html``;
  const entries = replay.openList(side, SHOWN_ENTRIES),
    all = replay.sides[side]?.open.length ?? 0;
  const head = `${
    replay.sides.length > 1 ? `${say(lang, side === 1 ? "side.1" : "side.0")} · ` : ""
  }${say(lang, "openList", { n: entries.length, all })}`;
  if (entries.length === 0) return html`<h3>${head}</h3><p class="note">${say(lang, "openEmpty")}</p>`;
  const hasPoses = replay.trace.kind === "poses";
  return html`<h3>${head}</h3><p class="note">${say(lang, replay.trace.oldestFirst ? "openOldest" : "openOrder")}</p>
    <table><thead><tr><th></th><th>${say(
      lang,
      hasPoses ? "pose" : "place",
    )}</th><th class="number">f</th><th class="number">h</th><th class="number">${say(lang, "age")}</th></tr></thead>
    <tbody>${entries.map((one, i) => {
      const tied = (other: (typeof entries)[number] | undefined): boolean => other?.f === one.f;
      return html`<tr class=${tied(entries[i - 1]) || tied(entries[i + 1]) ? "tied" : ""}><td class="rank">${i + 1}</td>
        <td>${placeOf(lang, replay, side, one.node)}${one.deferred ? html` <i>${say(lang, "waits")}</i>` : nothing}</td>
        <td class="number">${cost(
          lang,
          replay,
          one.f,
        )}</td><td class="number">${cost(lang, replay, one.h)}</td><td class="number">${one.age}</td></tr>`;
    })}</tbody></table>`;
}

export function code(lang: Lang, replay: SearchReplay, byMoves: boolean): TemplateResult {
  return html`<h3>${say(lang, "code")}</h3><ol class="code">${pseudocode(lang, replay, byMoves).map(
    (line) =>
      html`<li class=${line.current ? "now" : ""} aria-current=${line.current ? "step" : nothing}
        .style=${`padding-left:${14 + 16 * line.indent}px`}>${line.text}</li>`,
  )}</ol>`;
}

/** The variables beside the pseudocode. */
export function variables(lang: Lang, replay: SearchReplay): TemplateResult | typeof nothing {
  const { step, move, trace } = replay;
  if (step < 0) return nothing;
  const sampling = samplingOf(replay),
    isCandidate = sampling === "candidates",
    at = (column: Float64Array): string => cost(lang, replay, nth(column, step));
  const rows: [string, string][] = isCandidate
    ? [[say(lang, "fitness"), at(trace.f)]]
    : [
        ["n", placeOfStep(lang, replay, step)],
        ["g(n)", at(trace.g)],
      ];
  if (sampling === "tree") rows.push(["|n − r|", at(trace.h)]);
  if (!sampling) rows.push(["h(n)", at(trace.h)], ["f(n)", at(trace.f)]);
  if (move >= 0) {
    rows.push(["m", targetOf(lang, replay, move)]);
    if (!sampling) rows.push(["g(n) + c", cost(lang, replay, nth(trace.targetG, move))]);
  }
  if (!isCandidate)
    rows.push([sampling ? "|tree|" : "|open|", replay.sides.map(({ open }) => open.length).join(" + ")]);
  return html`<dl aria-label=${say(lang, "vars")}>${rows.map(
    ([name, value]) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`,
  )}</dl>`;
}

const ESTIMATES = {
  manhattan: "estimates.manhattan",
  octile: "estimates.octile",
  euclid: "estimates.euclid",
  chebyshev: "estimates.chebyshev",
} as const;

/** What the heuristics say at the node at hand, and which say too much for these moves. */
export function estimatesCard(
  lang: Lang,
  replay: SearchReplay,
  goal: { x: number; y: number },
): TemplateResult | typeof nothing {
  const { step, trace } = replay,
    node = step < 0 ? -1 : nth(trace.nodes, step),
    found = step < 0 ? null : estimatesAt(replay, node, goal);
  if (!found) return nothing;
  const names = keysOf(found.all);
  // Rounding down to whole micro-cells is no overestimate.
  const over = names.filter((name) => found.all[name] > found.least + 1);
  const list = over.map((name) => say(lang, ESTIMATES[name])).join(", ");
  return html`<section><h3>${say(lang, "estimates", { place: placeOfStep(lang, replay, step) })}</h3>
    <dl>${names.map(
      (name) =>
        html`<div class=${over.includes(name) ? "over" : ""}><dt>${say(lang, ESTIMATES[name])}</dt><dd>${cost(
          lang,
          replay,
          found.all[name],
        )}</dd></div>`,
    )}</dl>
    <p class="note">${say(lang, "estimates.least", { g: cost(lang, replay, found.least) })}
      ${over.length > 0 ? say(lang, "estimates.over", { names: list }) : say(lang, "estimates.under")}</p></section>`;
}

/** The risk field in the terms of its tables. */
export function fieldCard(
  lang: Lang,
  { cell, force, attraction, repulsion, mode, region, candidates }: Explanation,
): TemplateResult {
  const two = (value: number): string => number(lang, value, 2);
  const cells = (role: string): string =>
    candidates
      .filter((one) => one.role === role)
      .map((one) => one.direction)
      .join(", ");
  return html`<h3>${say(lang, "field", { place: `(${cell[0]}, ${cell[1]})` })}</h3>
    <p>${say(lang, "field.force", {
      x: two(force[0]),
      y: two(force[1]),
      ax: two(attraction[0]),
      ay: two(attraction[1]),
      rx: two(repulsion[0]),
      ry: two(repulsion[1]),
    })}</p>
    <p>${say(lang, "field.region", { table: mode === "oblique" ? 1 : 2, region, cells: cells("primary") })}
      ${say(lang, "field.skips", { cells: cells("held-back") })}</p>`;
}

/** The kinds of steps that a search has. */
export function unitsOf(replay: SearchReplay): readonly Unit[] {
  if (samplingOf(replay)) return ["step", "move", "refused"];
  const without = replay.trace.kind === "poses" ? "held" : "failure";
  return UNITS.filter((unit) => unit !== without);
}

/** What the colours on the map mean. */
export function legend(lang: Lang, replay: SearchReplay): TemplateResult {
  const sampling = samplingOf(replay),
    hasPoses = replay.trace.kind === "poses";
  const closed = html`<i class=${hasPoses ? "closed" : "ramp"}></i>${say(
    lang,
    hasPoses ? "legend.expanded" : "legend.closed",
  )}`;
  const open = html`<i class="open"></i>${say(lang, sampling ? "legend.tree" : "legend.open")}`;
  const back = html`<i class="back"></i>${say(lang, "legend.back")}`;
  return html`<p class="note legend">${sampling ? nothing : closed}${
    sampling === "candidates" ? nothing : open
  }${replay.sides.length > 1 ? back : nothing}</p>`;
}
