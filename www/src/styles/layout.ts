import { css } from "lit";

/** Where the panels stand: columns in the wide layout, a stack in the narrow one, rails where the window is low. */
export const layout = css`
  :host { display: block; position: relative; min-height: 320px; overflow: hidden; container-type: size; }
  .layout-wide, .layout-narrow { position: absolute; inset: 0; display: grid; }
  .layout-wide {
    grid-template: "bar bar" 49px "options side" auto "stage side" minmax(0, 1fr) "time side" 44px
      "bottom bottom" var(--bottom, 202px) / minmax(0, 1fr) var(--pane-side, 280px);
    --bottom: var(--pane-bottom, 202px);
  }
  :host([folded]) .layout-wide { --bottom: 0px; }
  :host([folded]) .bottom-pane { visibility: hidden; }
  parkade-toolbar { grid-area: bar; } parkade-options { grid-area: options; }
  parkade-stage { grid-area: stage; }
  parkade-timeline { grid-area: time; }
  parkade-inspector { grid-area: side; min-height: 0; }
  .bottom-pane {
    grid-area: bottom; display: grid;
    grid-template-columns: minmax(0, 1fr) var(--pane-chart, clamp(320px, 100% - 850px, 34%));
    border-top: 1px solid var(--parkade-hair); min-height: 0; overflow: hidden; background: var(--parkade-panel);
  }
  parkade-splitter[pane="side"] { grid-area: stage; justify-self: end; }
  parkade-splitter[pane="bottom"] { grid-area: bottom; align-self: start; }
  parkade-splitter[pane="chart"] { grid-area: 1 / 2; justify-self: start; }
  .bottom-pane > * { grid-row: 1; min-width: 0; }
  .bottom-pane > parkade-table { grid-column: 1; }
  .bottom-pane > parkade-charts { grid-column: 2; }
  parkade-splitter:focus-visible { outline: none; }
  :host([folded]) parkade-splitter[pane="bottom"] { display: none; }
  @container (max-width: 1180px) {
    .bottom-pane { grid-template-columns: minmax(0, 1fr); }
    .bottom-pane :is(parkade-charts, parkade-splitter) { display: none; }
  }
  @container (max-width: 960px) {
    .layout-wide { grid-template-columns: minmax(0, 1fr) 0; }
    .layout-wide parkade-splitter[pane="side"], :host(:not([inspecting])) .layout-wide parkade-inspector {
      display: none;
    }
    .layout-wide parkade-inspector {
      grid-area: 2 / 1 / 4 / 2; justify-self: end; width: min(300px, 60cqw); z-index: 15;
      box-shadow: var(--parkade-float);
    }
  }
  /* The inspector has them where it is shown. */
  @container (min-width: 961px) { .layout-wide > parkade-options { display: none; } }
  @media (max-height: 640px) { .layout-wide { --bottom: 130px; } }
  .layout-narrow {
    grid-template: "bar" 45px "stage" minmax(0, 1fr) "chips" minmax(57px, auto) "time" 48px "sheet" auto /
      minmax(0, 1fr);
  }
  .layout-narrow.rails {
    grid-template: "bar stage drawer" 44px "bar stage chips" minmax(0, 1fr) "bar options chips" auto
      "bar time chips" 37px /
      49px minmax(0, 1fr) 57px;
  }
  .rails parkade-sheet { grid-area: drawer; }
  .layout-narrow.bare:not(.rails) { grid-template-rows: 45px minmax(0, 1fr) 57px 48px calc(113px + min(148px, 60vh)); }
  :host([short]) :is(.bottom-pane, parkade-splitter[pane="bottom"]) { display: none; }
  :host([short]) .layout-wide { --bottom: 0px; }
  :host([short]) .layout-narrow { grid-template-rows: 45px minmax(0, 1fr) minmax(57px, auto) 48px 0; }
  parkade-chips { grid-area: chips; } .layout-narrow:not(.rails) parkade-chips:not(:defined) { height: 57px; }
  parkade-failure { grid-area: stage; align-self: end; z-index: 3; }
  parkade-choices { grid-area: stage; position: relative; align-self: start; top: 40px; }
  parkade-sheet { grid-area: sheet; }
  .layout-narrow:not(.rails) parkade-sheet:not(:defined) { height: calc(113px + min(148px, 60vh)); }
  :host([viewing]) parkade-stage { pointer-events: none; }
  :host([controls="minimal"]) .layout-wide { grid-template: "stage" minmax(0, 1fr) "time" 44px / minmax(0, 1fr); }
  :host([controls="minimal"]) .layout-narrow { grid-template: "stage" minmax(0, 1fr) "time" 48px / minmax(0, 1fr); }
  :host([controls="none"]) :is(.layout-wide, .layout-narrow) { grid-template: "stage" minmax(0, 1fr) / minmax(0, 1fr); }
  :host([controls="none"]) parkade-timeline { display: none; }
  :host([controls="none"]) { --parkade-scale: none; }
  .dropping {
    position: absolute; inset: 12px; z-index: 40; display: grid; place-items: center; pointer-events: none;
    border: 2px dashed var(--parkade-accent); border-radius: calc(14px * var(--parkade-radius));
    background: color-mix(in srgb, var(--parkade-accent-soft) 88%, transparent); color: var(--parkade-accent);
    font-size: 17px; line-height: 24px; font-weight: 600;
  }
`;
