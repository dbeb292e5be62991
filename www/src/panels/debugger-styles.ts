import { css } from "lit";

/** Of the layout around: the debugger has a place of its own, so that the map shows every step beside it. */
export const room = css`
  parkade-debugger { grid-area: side; z-index: 16; border-left: 1px solid var(--parkade-hair); }
  .layout-wide { --pane-side: 380px; }
  parkade-splitter[pane="side"] { display: none; }
  @container (max-width: 960px) {
    .layout-wide { grid-template-columns: minmax(0, 1fr) min(380px, 46cqw); }
    .layout-wide > parkade-inspector { visibility: hidden; }
    .layout-wide > parkade-debugger { grid-area: 2 / 2 / 4 / 3; }
    .layout-wide > parkade-timeline { grid-column: 1 / 3; }
  }
  .layout-narrow > :is(parkade-chips, parkade-sheet) { display: none; }
  .layout-narrow.rails { grid-template-columns: 49px minmax(0, 1fr) min(340px, 46cqw); }
  .rails > parkade-debugger { grid-area: 1 / 3 / -1 / 4; }
  :host .layout-narrow:not(.rails) { grid-template: "bar" 45px "stage" minmax(0, 1fr) "sheet" 46cqh / minmax(0, 1fr); }
  .layout-narrow:not(.rails) > parkade-timeline { display: none; }
  .layout-narrow:not(.rails) > parkade-debugger {
    grid-area: sheet; border-left: 0; border-top: 1px solid var(--parkade-hair); box-shadow: var(--parkade-lift);
  }
`;

export const debuggerStyles = css`
  :host {
    min-width: 0; min-height: 0; overflow-y: auto; overscroll-behavior: contain; background: var(--parkade-panel);
    scrollbar-width: thin; scrollbar-color: var(--parkade-hair2) transparent;
  }
  @container (max-height: 479px) { .keys-row select:first-of-type { max-width: 84px; } }
  section { padding: 10px 14px; border-top: 1px solid var(--parkade-hair); }
  section:first-child { border-top: 0; }
  .head {
    position: sticky; top: 0; z-index: 2; display: flex; align-items: center; gap: 8px; height: 44px;
    padding: 0 6px 0 14px; background: var(--parkade-panel); border-bottom: 1px solid var(--parkade-hair);
  }
  .head + section { border-top: 0; }
  h2 { display: flex; align-items: center; gap: 6px; margin: 0; font-size: 13px; line-height: 18px; font-weight: 600; }
  .planner-name {
    flex: 1; min-width: 0; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; color: var(--parkade-t2);
  }
  h3 { margin: 0 0 4px; font-size: 12px; line-height: 16px; font-weight: 600; }
  table ~ h3, p ~ h3 { margin-top: 12px; }
  p { margin: 0; }
  .note { color: var(--parkade-t3); font-size: 12px; line-height: 16px; }
  .transport { position: sticky; top: 44px; z-index: 1; background: var(--parkade-panel); padding-bottom: 6px; }
  .transport + section { border-top: 1px solid var(--parkade-hair); }
  .keys-row { display: flex; flex-wrap: wrap; align-items: center; gap: 2px; margin: 0 -6px; }
  select {
    appearance: none; border: 0; background: none; height: 32px; padding: 0 6px; font-weight: 500; cursor: pointer;
    border-radius: calc(6px * var(--parkade-radius)); min-width: 0; text-overflow: ellipsis;
  }
  select:first-of-type { margin-left: auto; max-width: 112px; } .keys-row .icon { width: 30px; }
  select:hover { background: var(--parkade-hover); }
  option { background: var(--parkade-raise); color: var(--parkade-t1); }
  .legend { display: flex; flex-wrap: wrap; align-items: center; gap: 0 5px; margin-top: 2px; }
  .legend i { width: 12px; height: 12px; flex: none; }
  .legend i ~ i { margin-left: 8px; }
  .ramp { background: linear-gradient(90deg, #00224e, #8a8678, #fde838); opacity: .6; width: 24px !important; }
  .closed { background: var(--parkade-t2); }
  .open { border: 1.5px solid var(--parkade-accent); }
  .back { background: var(--parkade-warn); opacity: .5; }
  .event { min-height: 56px; font-weight: 500; }
  .event b { color: var(--parkade-accent); }
  table { width: 100%; border-collapse: collapse; font-size: 12px; line-height: 16px; }
  th { font-weight: 400; color: var(--parkade-t3); text-align: left; padding: 2px 4px; white-space: nowrap; }
  td { padding: 2px 4px; vertical-align: top; white-space: nowrap; }
  td.why { white-space: normal; color: var(--parkade-t2); }
  .number { text-align: right; }
  .sign, .rank { width: 18px; text-align: center; color: var(--parkade-t3); }
  tr.now td { background: var(--parkade-accent-soft); }
  tr.bad .sign { color: var(--parkade-err); }
  tr.tied td { box-shadow: inset 2px 0 0 var(--parkade-hair2); } tr.tied td ~ td { box-shadow: none; }
  td i { color: var(--parkade-t3); }
  .code {
    margin: 0 -14px; padding: 0; list-style: none;
    font: 400 12.5px/18px ui-monospace, SFMono-Regular, Menlo, Consolas, monospace;
  }
  .code li { padding: 1px 14px; }
  .code li.now { background: var(--parkade-accent-soft); color: var(--parkade-accent); font-weight: 600; }
  dl { display: flex; flex-wrap: wrap; gap: 2px 14px; margin: 8px 0 0; font-size: 12px; line-height: 16px; }
  dl div { display: flex; gap: 5px; } dt { color: var(--parkade-t3); } dd { margin: 0; font-weight: 500; }
  dl .over dd { color: var(--parkade-err); } dl + .note { margin-top: 4px; }
  .rows { display: flex; flex-wrap: wrap; gap: 6px; margin-bottom: 6px; }
  .button[aria-pressed="true"] { background: var(--parkade-accent-soft); color: var(--parkade-accent); }
  .check { display: flex; align-items: center; gap: 8px; min-height: 28px; }
  .check .field { width: 80px; }
  @media (pointer: coarse) { .check, select { min-height: 44px; } .chip { height: 32px; } }
`;
