// Heat maps as SVG: a number in each cell, both axes with their sizes, in the reader's light or dark scheme.
// @ts-check

/**
 * A panel: what its numbers are, and each cell's text and step on the colour scale (null where there is nothing to
 * say), rows from the bottom up.
 * @typedef {{ text: string, step: number, isMarked?: boolean }} Cell
 * @typedef {{ title: string, scale: "good" | "bad", cells: (Cell | null)[][] }} Panel
 * @typedef {{ title: string, sizes: number[] }} Axis
 * @typedef {{ title: string, along: Axis, up: Axis, panels: Panel[], note?: string }} Figure
 */

/** Fill and text of each step; each pair contrasts by 4.5 or more. */
export const SCALES = {
  good: {
    light: [
      ["#f0f2f4", "#454b52"],
      ["#d5ebe6", "#1d3a35"],
      ["#a8d8cd", "#12332d"],
      ["#6cbdac", "#06231e"],
      ["#1f7a6a", "#ffffff"],
      ["#0b574b", "#ffffff"],
    ],
    dark: [
      ["#2a2d33", "#b4bac2"],
      ["#1c3b37", "#d9efe9"],
      ["#1d544c", "#e6f7f2"],
      ["#24695e", "#ffffff"],
      ["#45b09b", "#05201b"],
      ["#86dcc8", "#06231e"],
    ],
  },
  bad: {
    light: [
      ["#fdf3e3", "#4a3511"],
      ["#fbe0b4", "#432d07"],
      ["#f6c374", "#3a2503"],
      ["#e79a3a", "#2b1a00"],
      ["#a95d0c", "#ffffff"],
      ["#77400a", "#ffffff"],
    ],
    dark: [
      ["#33291a", "#f3dfbf"],
      ["#4e3713", "#fbe9cb"],
      ["#6c4810", "#fff3de"],
      ["#8a5a0e", "#ffffff"],
      ["#e09b3d", "#241500"],
      ["#f7c987", "#2b1a00"],
    ],
  },
};

/** Axes and titles on the page's own ground. */
export const INK = { light: "#3c4148", dark: "#d5d9df" };

const WIDTH = 680,
  LEFT = 62,
  RIGHT = 10,
  HEAD = 30,
  PANEL_HEAD = 30,
  CELL = 26,
  FOOT = 44,
  NOTE = 22;

/** @param {Figure} figure */
export function heatMap({ title, along, up, panels, note }) {
  const high = PANEL_HEAD + up.sizes.length * CELL + FOOT;
  const height = HEAD + panels.length * high + (note ? NOTE : 0);
  const parts = panels.map((panel, i) => panelOf(panel, along, up, HEAD + i * high));
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 ` +
    `0 ${WIDTH} ${height}" width="${WIDTH}" height="${height}" role="img" font-family="system-ui,sans-serif" ` +
    `font-size="13" text-anchor="middle">
<title>${title}</title>
<style>${styleOf("light", panels)}@media(prefers-color-scheme:dark){${styleOf("dark", panels)}}</style>
<text x="${LEFT}" y="19" class="i" text-anchor="start" font-size="15" font-weight="600">${title}</text>
${parts.join("\n")}
${
  note
    ? `<circle cx="${LEFT + 4}" cy="${height - 11}" r="3" class="i"/><text ` +
      `x="${LEFT + 13}" y="${height - 7}" class="i" text-anchor="start">${note}</text>\n`
    : ""
}</svg>
`
  );
}

/** @param {"light" | "dark"} scheme @param {Panel[]} panels */
function styleOf(scheme, panels) {
  const rules = [...new Set(panels.map(({ scale }) => scale))].flatMap((scale) =>
    SCALES[scale][scheme].map(([fill, text], step) => {
      const name = `${scale[0]}${step}`;
      return `.${name}{fill:${fill}}.${name}t{fill:${text}}`;
    }),
  );
  return `.i{fill:${INK[scheme]}}${rules.join("")}`;
}

/** @param {Panel} panel @param {Axis} along @param {Axis} up @param {number} top */
function panelOf({ title, scale, cells }, along, up, top) {
  const wide = (WIDTH - LEFT - RIGHT) / along.sizes.length,
    low = top + PANEL_HEAD + up.sizes.length * CELL;
  const x = (/** @type {number} */ column) => round(LEFT + column * wide);
  const y = (/** @type {number} */ row) => low - (row + 1) * CELL;
  const placed = cells.flatMap((row, j) => row.map((cell, i) => ({ cell, i, j })));
  const text = (/** @type {{ cell: Cell | null, i: number, j: number }} */ { cell, i, j }) => {
    const mark = cell?.isMarked ? `<circle cx="${round(x(i + 1) - 7)}" cy="${y(j) + 6}" r="3"/>` : "";
    return `<text x="${x(i + 0.5)}" y="${y(j) + 17}">${cell ? cell.text : "–"}</text>${mark}`;
  };
  // One outline and one group of texts for each step: half the bytes of one for each cell.
  const steps = SCALES[scale].light.map((_, step) => {
    const own = placed.filter(({ cell }) => cell?.step === step);
    const boxes = own.map(({ i, j }) => `M${x(i)} ${y(j)}h${round(wide - 1)}v${CELL - 1}h${round(1 - wide)}z`).join("");
    return own.length > 0
      ? `<path class="${scale[0]}${step}" d="${boxes}"/><g class="${scale[0]}${step}t">${own.map(text).join("")}</g>`
      : "";
  });
  const none = placed.filter(({ cell }) => cell === null).map(text);
  const ticks = [
    ...along.sizes.map((size, i) => `<text x="${x(i + 0.5)}" y="${low + 16}">${size.toFixed(1)}</text>`),
    ...up.sizes.map((size, j) => `<text x="${LEFT - 8}" y="${y(j) + 17}" text-anchor="end">${size.toFixed(1)}</text>`),
  ];
  const middle = low - (up.sizes.length * CELL) / 2;
  return `<text x="${LEFT}" y="${top + 20}" class="i" text-anchor="start" font-weight="600">${title}</text>
${steps.join("")}
<g class="i">${none.join("")}${ticks.join("")}<text x="${x(
    along.sizes.length / 2,
  )}" y="${low + 34}">${along.title}</text><text transform="translate(16 ${middle})rotate(-90)">${up.title}</text></g>`;
}

const round = (/** @type {number} */ value) => Math.round(value * 10) / 10;
