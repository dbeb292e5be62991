import { svg, html, type SVGTemplateResult, type TemplateResult } from "lit";
import { drivesCar, identityOf, type Shape } from "./planner-style";

const shapes = {
  select: svg`<path d="M4 2.5v10l2.7-2.5 1.7 3.8 1.7-.8-1.7-3.7h3.6z"/>`,
  brush: svg`<path
    d="M13.2 2.3c-2 .5-5.4 3.3-6.7 5.4l1.8 1.8c2.1-1.3 4.9-4.7 5.4-6.7.1-.4-.1-.6-.5-.5zM6.2
    9c-1.7-.1-2.3 1-2.5 2.2-.1.9-.6 1.6-1.4 2 2.2.7 5.1.3 5.3-2.1"/>`,
  wall: svg`<circle cx="3.4" cy="12.6" r="1.4"/><circle cx="12.6" cy="3.4" r="1.4"/><path d="M4.4 11.6l7.2-7.2"/>`,
  rectangle: svg`<rect x="2" y="4" width="12" height="8"/>`,
  polygon: svg`<path d="M8 2.2l5.8 4.3-2.2 7H4.4l-2.2-7z"/>`,
  car: svg`<rect x="4.5" y="1.8" width="7" height="12.4"
    rx="2.2"/><path d="M5.8 5.8c1.4-.6 3-.6 4.4 0M5.9 11.2c1.3.4 2.9.4 4.2 0"/>`,
  slot: svg`<path d="M2.5 2.5v11h11v-11M8 2.5v11"/>`,
  road: svg`<path d="M2.5 13.5L6 2.5M13.5 13.5L10 2.5M8 3v2M8 7v2M8 11.3v2.2"/>`,
  eraser: svg`<path d="M6 13.3l-3.3-3.3 6.5-6.8 4.3 4.2-5.7 5.9zM5.8 6.8l4.3 4.2M5.5 13.3h8"/>`,
  hand: svg`<path
    d="M4.8 8.5V4.3a1 1 0 0 1 2 0v3M6.8 7V2.8a1 1 0 0 1 2 0V7M8.8 7V3.6a1 1 0 0 1 2 0V8M10.8
    8V5.3a1 1 0 0 1 2 0v4.2c0 2.8-1.6 4.5-4.1 4.5-2 0-3-.8-4-2.6L3 8.3c-.3-.9.9-1.5 1.5-.7l.9 1.4"/>`,
  undo: svg`<path d="M3 6.2h6.7a3.4 3.4 0 0 1 0 6.8H6M5.8 3.2l-3 3 3 3"/>`,
  redo: svg`<path d="M13 6.2H6.3a3.4 3.4 0 0 0 0 6.8H10M10.2 3.2l3 3-3 3"/>`,
  cost: svg`<path d="M2.5 2.5h11v11h-11zM2.5 9l6.5-6.5M2.5 13.5l11-11M7 13.5 13.5 7"/>`,
  moving: svg`<rect x="2.5" y="5" width="6" height="6"/><path d="M10.5 8h3.5M12 6l2 2-2 2"/>`,
  planners: svg`<circle cx="3.5" cy="12" r="1.6"/><circle cx="12.5" cy="4"
    r="1.6"/><path d="M5 11.2C8.5 9.5 5.5 6 10.9 4.3M5.1 12h7.4"/>`,
  layers: svg`<path d="M8 2.5l6 3-6 3-6-3zM2.6 8.3L8 11l5.4-2.7M2.6 10.9L8 13.6l5.4-2.7"/>`,
  grid: svg`<rect x="2.5" y="2.5" width="4.5" height="4.5"/><rect x="9" y="2.5" width="4.5" height="4.5"/><rect x="2.5"
    y="9" width="4.5" height="4.5"/><rect x="9" y="9" width="4.5" height="4.5"/>`,
  overlay: svg`<rect x="2.5" y="2.5" width="8" height="8" rx="1"/><rect x="5.5" y="5.5" width="8" height="8" rx="1"/>`,
  focus: svg`<rect x="2.5" y="2.5" width="7.5"
    height="11"/><path d="M12.7 2.5h1v2.3h-1zM12.7 6.8h1v2.3h-1zM12.7 11.2h1v2.3h-1z"/>`,
  export: svg`<path d="M8 2.5v7.5M5 7.2l3 3 3-3M2.5 11v2.5h11V11"/>`,
  open: svg`<path d="M8 10.5V3M5 5.8l3-3 3 3M2.5 11v2.5h11V11"/>`,
  theme: svg`<circle cx="8" cy="8" r="5.5"/><path class="fill" d="M8 2.5a5.5 5.5 0 0 1 0 11z"/>`,
  help: svg`<path d="M5.6 5.7c0-1.5 1-2.4 2.4-2.4s2.4.9 2.4 2.2c0 1.8-2.4 1.9-2.4 3.9M8 12.6v.1"/>`,
  share: svg`<path
    d="M6.8 9.2a2.6 2.6 0 0 0 3.7 0l2.3-2.3a2.6 2.6 0 0 0-3.7-3.7l-.9.9M9.2
    6.8a2.6 2.6 0 0 0-3.7 0L3.2 9.1a2.6 2.6 0 0 0 3.7 3.7l.9-.9"/>`,
  more: svg`<path d="M3 8h.1M8 8h.1M13 8h.1" stroke-width="2.4"/>`,
  eye: svg`<path d="M1.8 8S4 3.8 8 3.8 14.2 8 14.2 8 12 12.2 8 12.2 1.8 8 1.8 8z"/><circle cx="8" cy="8" r="1.9"/>`,
  eyeOff: svg`<path d="M1.8 6.8c1.4 2 3.6 3.4 6.2 3.4s4.8-1.4 6.2-3.4M8 10.2v2.3M4.2 9.2l-1.3 1.9M11.8 9.2l1.3 1.9"/>`,
  maximise: svg`<path d="M2.5 6V2.5H6M10 13.5h3.5V10M9.7 2.5h3.8v3.8M6.3 13.5H2.5V9.7"/>`,
  restore: svg`<path d="M6 2.5V6H2.5M13.5 10H10v3.5M10 2.5V6h3.5M6 13.5V10H2.5"/>`,
  first: svg`<path d="M3.5 3.5v9M12.5 3.8v8.4L6 8z"/>`,
  last: svg`<path d="M12.5 3.5v9M3.5 3.8v8.4L10 8z"/>`,
  back: svg`<path d="M10.5 4v8L5 8z"/>`,
  next: svg`<path d="M5.5 4v8L11 8z"/>`,
  play: svg`<path class="fill" d="M4.5 3v10l8-5z"/>`,
  pause: svg`<path d="M5.5 3.5v9M10.5 3.5v9"/>`,
  loop: svg`<path d="M2.8 7.3V6.5a2 2 0 0 1 2-2h8M10.8 2.5l2 2-2 2M13.2 8.7v.8a2 2 0 0 1-2 2h-8M5.2 13.5l-2-2 2-2"/>`,
  copy: svg`<rect x="5.5" y="5.5" width="8" height="8"
    rx="1.5"/><path d="M10.5 3.5v-.2a.8.8 0 0 0-.8-.8H3.3a.8.8 0 0 0-.8.8v6.4c0 .4.4.8.8.8h.2"/>`,
  check: svg`<path d="M3 8.4l3.2 3.1L13 4.6"/>`,
  warning: svg`<path d="M8 2.3l6.3 11H1.7zM8 6.4v3.2M8 11.5v.1"/>`,
  turned: svg`<path d="M3 13V8.5a4 4 0 0 1 4-4h6M10.2 1.7L13 4.5l-2.8 2.8"/>`,
  clock: svg`<circle cx="8" cy="8" r="5.7"/><path d="M8 4.7V8l2.2 1.5"/>`,
  close: svg`<path d="M3.5 3.5l9 9M12.5 3.5l-9 9"/>`,
  down: svg`<path d="M4.5 6.3L8 9.8l3.5-3.5"/>`,
  trash: svg`<path d="M2.8 4.3h10.4M6 4.3V2.5h4v1.8M4.3 4.3l.6 9.2h6.2l.6-9.2M6.7 7v3.8M9.3 7v3.8"/>`,
  flip: svg`<path d="M8 13.5v-11M5.2 5.3L8 2.5l2.8 2.8M5.2 10.7L8 13.5l2.8-2.8"/>`,
  fit: svg`<path d="M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3M5.5 8h5M8 5.5v5"/>`,
  image: svg`<rect x="2.5" y="3" width="11" height="10"
    rx="1.5"/><path d="M2.8 11l3.2-3.2 2.5 2.5 1.8-1.8 3 2.8M10.7 5.9v.1"/>`,
  file: svg`<path d="M4 2.5h5.2L12.5 6v7.5H4zM9 2.7V6h3.2"/>`,
  cells: svg`<path d="M2.5 3h11v10h-11zM2.5 6.3h11M2.5 9.6h11M6.2 3v10"/>`,
  lock: svg`<rect x="3.5" y="7" width="9" height="6.5" rx="1.5"/><path d="M5.5 7V5a2.5 2.5 0 0 1 5 0v2"/>`,
  language: svg`<circle cx="8" cy="8"
    r="5.7"/><path d="M2.3 8h11.4M8 2.3c-3.4 3.4-3.4 8 0 11.4M8 2.3c3.4 3.4 3.4 8 0 11.4"/>`,
  sliders: svg`<path d="M2.5 4.5h6M12 4.5h1.5M2.5 11.5H4M7.5 11.5h6"/><circle cx="10.3" cy="4.5"
    r="1.7"/><circle cx="5.7" cy="11.5" r="1.7"/>`,
} satisfies Record<string, SVGTemplateResult>;

export type IconName = keyof typeof shapes;

/** A decorative 16-unit icon with 1.5 px strokes at every drawn size; its button carries the name. */
export function icon(name: IconName, size = 16): TemplateResult {
  return html`<svg width=${size} height=${size} viewBox="0 0 16 16" fill="none" stroke="currentColor"
    stroke-width=${(1.5 * 16) / size} stroke-linecap="round" stroke-linejoin="round"
    aria-hidden="true">${shapes[name]}</svg>`;
}

/** The wordmark's sign: a car in its slot. */
export function logo(): TemplateResult {
  return html`<svg width="20" height="20" viewBox="0 0 20 20" fill="none" stroke="currentColor" stroke-width="1.5"
    stroke-linecap="round" stroke-linejoin="round" aria-hidden="true">
    <path d="M2.5 3v14.5h15V3"/><rect x="6.7" y="2.5" width="6.6" height="11.5"
      rx="2.2"/><path d="M8.3 6.3c1.1-.4 2.3-.4 3.4 0"/></svg>`;
}

const markers: Record<Shape, SVGTemplateResult> = {
  circle: svg`<circle cx="6" cy="6" r="5"/>`,
  triangle: svg`<path d="M6 .8l5.6 10H.4z"/>`,
  square: svg`<rect x="1.2" y="1.2" width="9.6" height="9.6"/>`,
  diamond: svg`<path d="M6 .2L11.8 6 6 11.8.2 6z"/>`,
  plus: svg`<path d="M4.3.8h3.4v3.5h3.5v3.4H7.7v3.5H4.3V7.7H.8V4.3h3.5z"/>`,
  pentagon: svg`<path d="M6 .5l5.7 4.1-2.2 6.7h-7L.3 4.6z"/>`,
  wedge: svg`<path d="M6 11.2L.4 1.2h11.2z"/>`,
  cross: svg`<path d="M2.6.6L6 4 9.4.6l2 2L8 6l3.4 3.4-2 2L6 8l-3.4 3.4-2-2L4 6 .6 2.6z"/>`,
  bars: svg`<path d="M1.2 1.2h9.6v3.4H1.2zM1.2 7.4h9.6v3.4H1.2z"/>`,
  hexagon: svg`<path d="M3.2.8h5.6L11.6 6l-2.8 5.2H3.2L.4 6z"/>`,
};

/** A planner's shape in its colour; always beside its name. */
export function marker(planner: string, size = 11): TemplateResult {
  return html`<svg width=${size} height=${size} viewBox="0 0 12 12" fill=${plannerColour(planner)}
    aria-hidden="true">${markers[identityOf(planner).shape]}</svg>`;
}

/** The planner's line as drawn on the map, for legends. */
export function lineSample(planner: string): TemplateResult {
  const { dash } = identityOf(planner),
    drives = drivesCar(planner);
  return html`<svg width="26" height="4" viewBox="0 0 26 4" aria-hidden="true"><path d="M0 2h26"
    stroke=${plannerColour(planner)}
    stroke-width=${drives ? 3 : 2} stroke-dasharray=${dash.join(" ") || "none"}/></svg>`;
}

export const plannerColour = (planner: string): string => `var(--parkade-planner-${identityOf(planner).colour})`;
