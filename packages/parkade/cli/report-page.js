// @ts-check
// The HTML of `parkade report`: one file, without scripts.

/** Colours that colour-blind readers tell apart; lines also differ by dash. */
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#56b4e9", "#7f3c8d", "#666666"];
const DASHES = ["", "6 3", "2 2", "8 2 2 2"];
const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP] = [640, 300, 48, 40, 10];

const STYLE =
  `
:root { color-scheme: light dark; --line: light-dark(#d8d8d2, #444); --soft: light-dark(#f4f4f0, #222); --muted: ` +
  `light-dark(#5b5b56, #b4b4ac); }
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; } h3 { font-size: 1rem; }
p { max-width: 45rem; color: var(--muted); }
div.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th:first-child { text-align: left; font-weight: 600; } thead th { background: var(--soft); font-weight: 600; }
svg { width: 100%; max-width: ${WIDTH}px; height: auto; } svg text { font-size: 12px; fill: currentColor; }
ul.key { list-style: none; padding: 0; display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; } ul.key svg { width: ` +
  `34px; vertical-align: middle; }
`;

/** @param {unknown} value */
const text = (value) =>
  String(value).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** @param {(string | number)[]} head @param {(string | number)[][]} rows */
const table = (head, rows) =>
  `<div class="wide"><table><thead><tr>${head
    .map((cell) => `<th scope="col">${text(cell)}</th>`)
    .join("")}</tr></thead><tbody>${rows
    .map(
      ([first, ...rest]) =>
        `<tr><th scope="row">${text(first)}</th>${rest.map((cell) => `<td>${text(cell)}</td>`).join("")}</tr>`,
    )
    .join("\n")}</tbody></table></div>`;

/** @param {number} i */
const stroke = (i) =>
  `fill="none" stroke="${COLOURS[i % COLOURS.length]}" stroke-width="2" ` +
  `stroke-dasharray="${DASHES[Math.floor(i / COLOURS.length) % DASHES.length] || DASHES[i % DASHES.length]}"`;

/** @param {number} share */
const percent = (share) => `${(100 * share).toFixed(1)} %`;

/** @param {number} part */
const nameOf = (part) => (part === 0 ? "least" : part === 1 ? "most" : part === 0.5 ? "median" : `${part * 100} %`);

/** Shares of scenes by the factor of the best. @param {any} comparison */
function profile({ figure, factors, profiles }) {
  const x = (/** @type {number} */ factor) =>
    LEFT + (WIDTH - LEFT - 10) * (Math.log(factor) / Math.log(factors.at(-1)));
  const y = (/** @type {number} */ share) => TOP + (HEIGHT - TOP - BOTTOM) * (1 - share);
  const lines = profiles.map((/** @type {any} */ { shares }, /** @type {number} */ i) => {
    const way = shares.map(
      (/** @type {number} */ share, /** @type {number} */ at) =>
        `${at === 0 ? "M" : "H"}${x(factors[at]).toFixed(1)}${at === 0 ? "," : "V"}${y(share).toFixed(1)}`,
    );
    return `<path d="${way.join("")}" ${stroke(i)}/>`;
  });
  const marks = [1, 1.5, 2, 3, 5, 10].map(
    (factor) => `<text x="${x(factor)}" y="${HEIGHT - BOTTOM + 18}" text-anchor="middle">${factor}×</text>`,
  );
  const shares = [0, 0.25, 0.5, 0.75, 1].map(
    (share) =>
      `<path d="M${LEFT},${y(share)}H${WIDTH - 10}" stroke="var(--line)"/><text ` +
      `x="${LEFT - 6}" y="${y(share) + 4}" text-anchor="end">${share * 100} %</text>`,
  );
  const key = profiles.map(
    (/** @type {any} */ { name }, /** @type {number} */ i) =>
      `<li><svg viewBox="0 0 34 10" aria-hidden="true"><path d="M0,5H34" ${stroke(i)}/></svg> ${text(name)}</li>`,
  );
  return (
    `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${text(
      `${figure.title}: share of scenes by the factor of the best`,
    )}">${shares.join("")}${marks.join("")}${lines.join("")}` +
    `<text x="${(LEFT + WIDTH) / 2}" y="${HEIGHT - 4}" text-anchor="middle">factor of the best</text></svg>` +
    `<ul class="key">${key.join("")}</ul>`
  );
}

/** @param {any} comparison */
function compared(comparison) {
  const { figure, scenes, profiles, matrix } = comparison;
  const names = profiles.map((/** @type {any} */ { name }) => name);
  const rows = matrix.map((/** @type {any[]} */ row, /** @type {number} */ i) => [
    names[i],
    ...row.map(({ wins, ties, losses }, j) => (i === j ? "" : `${wins} / ${ties} / ${losses}`)),
  ]);
  return (
    `<section><h2>${text(figure.title)}: compared on ${scenes} scenes</h2>
<p>The share of scenes on which a planner is within a factor of the ` +
    `least ${text(figure.title.toLowerCase())} that any of them has. Scenes without a path count against it.</p>
${profile(comparison)}
<h3>Wins, ties and losses of the row against the column</h3>
<p>Less wins. A path wins against none; two without a path tie.</p>
${table(["", ...names], rows)}</section>`
  );
}

/** @param {{ files: string[], outcomes: any[], quantiles: any[], parts: number[], comparisons: any[] }} found */
export function page({ files, outcomes, quantiles, parts, comparisons }) {
  const first = table(
    ["planner", "scenes", "found", "drivable", "no path", "refused", "found, share"],
    outcomes.map((o) => [o.name, o.scenes, o.found, o.drivable, o.none, o.refused, percent(o.found / o.scenes)]),
  );
  const figures = quantiles.map(({ figure, rows }) => {
    const unit = figure.unit ? `, ${figure.unit}` : "";
    const cells = rows.map((/** @type {any} */ { name, count, values }) => [
      name,
      count,
      ...parts.map((_, i) => values[i]?.toFixed(figure.digits) ?? ""),
    ]);
    return `<h3>${text(figure.title + unit)}</h3>${table(["planner", "paths", ...parts.map(nameOf)], cells)}`;
  });
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>Parkade: results</title><style>${STYLE}</style></head><body>
<h1>Results of ${outcomes.length} planners with settings</h1>
<p>From ${files.map((file) => `<code>${text(file)}</code>`).join(", ")}.</p>
<section><h2>Outcomes</h2><p>A drivable path passed the independent check of the car's body.</p>${first}</section>
<section><h2>Quantiles over the paths found</h2>${figures.join("\n")}</section>
${comparisons.map(compared).join("\n")}
</body></html>
`;
}
