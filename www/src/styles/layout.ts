import { css } from "lit";

/** Where the pieces stand: a desk with columns, or a phone's stack. */
export const layout = css`
  :host { display: block; position: relative; min-height: 320px; overflow: hidden; container-type: size; }
  .desk, .phone { position: absolute; inset: 0; display: grid; }
  .desk {
    grid-template: "bar bar" 49px "options side" auto "stage side" minmax(0, 1fr) "time side" 44px "strip strip" var(--strip, 202px) / minmax(0, 1fr) var(--pane-side, 280px);
    --strip: var(--pane-strip, 202px);
  }
  :host([folded]) .desk { --strip: 0px; }
  :host([folded]) .strip { visibility: hidden; }
  parkade-toolbar { grid-area: bar; } parkade-options { grid-area: options; }
  parkade-stage { grid-area: stage; }
  parkade-timeline { grid-area: time; }
  parkade-inspector { grid-area: side; min-height: 0; }
  .strip { grid-area: strip; display: grid; grid-template-columns: minmax(0, 1fr) var(--pane-chart, clamp(320px, 100% - 850px, 34%)); border-top: 1px solid var(--parkade-hair); min-height: 0; overflow: hidden; background: var(--parkade-panel); }
  parkade-splitter[pane="side"] { grid-area: stage; justify-self: end; }
  parkade-splitter[pane="strip"] { grid-area: strip; align-self: start; }
  parkade-splitter[pane="chart"] { grid-area: 1 / 2; justify-self: start; }
  .strip > * { grid-row: 1; min-width: 0; } .strip > parkade-table { grid-column: 1; } .strip > parkade-charts { grid-column: 2; }
  parkade-splitter:focus-visible { outline: none; }
  :host([folded]) parkade-splitter[pane="strip"] { display: none; }
  @container (max-width: 1180px) {
    .strip { grid-template-columns: minmax(0, 1fr); }
    .strip :is(parkade-charts, parkade-splitter) { display: none; }
  }
  @container (max-width: 960px) {
    .desk { grid-template-columns: minmax(0, 1fr) 0; }
    .desk parkade-splitter[pane="side"], :host(:not([inspecting])) .desk parkade-inspector { display: none; }
    .desk parkade-inspector { grid-area: 2 / 1 / 4 / 2; justify-self: end; width: min(300px, 60cqw); z-index: 15; box-shadow: var(--parkade-float); }
  }
  /* The inspector has them where it is shown. */
  @container (min-width: 961px) { .desk > parkade-options { display: none; } }
  @media (max-height: 640px) { .desk { --strip: 130px; } }
  .phone { grid-template: "bar" 45px "stage" minmax(0, 1fr) "chips" minmax(57px, auto) "time" 48px "sheet" auto / minmax(0, 1fr); }
  .phone.rails { grid-template: "bar stage drawer" 44px "bar stage chips" minmax(0, 1fr) "bar options chips" auto "bar time chips" 37px / 49px minmax(0, 1fr) 57px; }
  .rails parkade-sheet { grid-area: drawer; }
  .phone.bare:not(.rails) { grid-template-rows: 45px minmax(0, 1fr) 57px 48px calc(113px + min(148px, 60vh)); }
  :host([short]) :is(.strip, parkade-splitter[pane="strip"]) { display: none; }
  :host([short]) .desk { --strip: 0px; }
  :host([short]) .phone { grid-template-rows: 45px minmax(0, 1fr) minmax(57px, auto) 48px 0; }
  parkade-chips { grid-area: chips; } .phone:not(.rails) parkade-chips:not(:defined) { height: 57px; }
  parkade-failure { grid-area: stage; align-self: end; z-index: 3; }
  parkade-choices { grid-area: stage; position: relative; align-self: start; top: 40px; }
  parkade-sheet { grid-area: sheet; } .phone:not(.rails) parkade-sheet:not(:defined) { height: calc(113px + min(148px, 60vh)); }
  :host([viewing]) parkade-stage { pointer-events: none; }
  :host([controls="minimal"]) .desk { grid-template: "stage" minmax(0, 1fr) "time" 44px / minmax(0, 1fr); }
  :host([controls="minimal"]) .phone { grid-template: "stage" minmax(0, 1fr) "time" 48px / minmax(0, 1fr); }
  :host([controls="none"]) :is(.desk, .phone) { grid-template: "stage" minmax(0, 1fr) / minmax(0, 1fr); }
  :host([controls="none"]) parkade-timeline { display: none; }
  :host([controls="none"]) { --parkade-scale: none; }
  .dropping { position: absolute; inset: 12px; z-index: 40; display: grid; place-items: center; pointer-events: none; border: 2px dashed var(--parkade-accent); border-radius: calc(14px * var(--parkade-radius)); background: color-mix(in srgb, var(--parkade-accent-soft) 88%, transparent); color: var(--parkade-accent); font-size: 17px; line-height: 24px; font-weight: 600; }
`;
