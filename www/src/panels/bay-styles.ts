import { css } from "lit";

/**
 * Room for the panel: the way back stands above the inspector, and in a low window the table beside the map. On a phone
 * the table covers the lower part of the map, and the scale bar moves up.
 */
export const room = css`
  .layout-wide:has(~ parkade-bays[opened]) parkade-inspector { margin-top: 44px; }
  .layout-narrow:not(.rails):has(~ parkade-bays:not([hidden], [opened])) parkade-stage { --scale-block: 50px auto; }
  .rails:has(~ parkade-bays:not([hidden], [opened])) :is(parkade-stage, parkade-timeline) { margin-right: 360px; }
`;

export const bayStyles = css`
  :host {
    position: absolute; inset: 49px 0 0 auto; width: 420px; z-index: 16; display: grid;
    grid-template: auto auto minmax(0, 1fr) auto / minmax(0, 1fr); background: var(--parkade-panel);
    border-left: 1px solid var(--parkade-hair); font-size: 12px; line-height: 16px;
  }
  :host([hidden]) { display: none; }
  header { display: grid; gap: 8px; padding: 10px 14px; }
  .row { display: flex; align-items: center; gap: 8px; }
  h2 { margin: 0; font-size: 13px; line-height: 18px; font-weight: 600; flex: 1; }
  label { display: flex; align-items: center; gap: 6px; color: var(--parkade-t2); min-width: 0; }
  select {
    height: 28px; min-width: 0; max-width: 130px; padding: 0 4px; color: var(--parkade-t1);
    background: var(--parkade-panel); border: 1px solid var(--parkade-hair2);
    border-radius: calc(6px * var(--parkade-radius));
  }
  .summary { color: var(--parkade-t1); font-weight: 500; flex: 1; }
  .legend { display: flex; gap: 3px; align-items: center; color: var(--parkade-t2); }
  .legend b {
    min-width: 20px; padding: 0 4px; font-weight: 600; text-align: center; border-radius: 3px; color: var(--ink);
    background: var(--fill);
  }
  .legend .none {
    background: var(--parkade-err-soft); color: var(--parkade-err); border: 1px solid var(--parkade-err);
  }
  progress { appearance: none; display: block; width: 100%; height: 2px; border: 0; background: var(--parkade-hair); }
  progress::-webkit-progress-bar { background: var(--parkade-hair); }
  progress::-webkit-progress-value { background: var(--parkade-accent); }
  progress::-moz-progress-bar { background: var(--parkade-accent); }
  progress.done { visibility: hidden; }
  .scroll { overflow: auto; min-height: 0; }
  table { border-collapse: collapse; width: 100%; table-layout: fixed; }
  th, td {
    padding: 0 5px; overflow: hidden; text-overflow: ellipsis; text-align: right; font-weight: 400;
    white-space: nowrap;
  }
  :is(th, td):first-child { text-align: left; padding-left: 14px; }
  :is(th, td):last-child { padding-right: 14px; }
  thead th { position: sticky; top: 0; background: var(--parkade-panel); padding-block: 2px; }
  thead button {
    width: 100%; min-height: 28px; height: auto; justify-content: inherit; font-size: 12px; line-height: 14px;
    color: var(--parkade-t2); white-space: normal; text-align: inherit; display: block; overflow-wrap: normal;
    word-break: keep-all;
  }
  thead small { display: block; font-size: 12px; color: var(--parkade-t3); }
  table .button.button { padding: 0; }
  tbody tr { height: 33px; border-top: 1px solid var(--parkade-hair); cursor: pointer; }
  tbody tr.lit { box-shadow: inset 2px 0 0 var(--parkade-t1); background: var(--parkade-hover); }
  .stale { opacity: .5; }
  .err { color: var(--parkade-err); }
  thead th:first-child { width: 20%; }
  thead th:last-child { width: 20%; }
  tbody th button {
    max-width: 100%; display: block; overflow: hidden; text-overflow: ellipsis; min-height: 28px; font-weight: 600;
    font-size: 12px;
  }
  tbody td[colspan] { text-align: left; white-space: normal; line-height: 15px; padding-block: 4px; }
  footer { display: flex; gap: 6px; padding: 6px 14px; border-top: 1px solid var(--parkade-hair); }
  footer .button { font-size: 12px; }
  p { margin: 0; padding: 12px 14px; color: var(--parkade-t2); }
  .back { display: none; }
  :host([opened]) {
    inset: 49px 0 auto auto; width: var(--pane-side, 280px); height: 44px; box-sizing: border-box; display: flex;
    align-items: center; padding: 0 8px; border-bottom: 1px solid var(--parkade-hair);
  }
  :host([opened]) > :not(.back) { display: none; }
  :host([opened]) .back { display: flex; }
  :host(.phone) {
    inset: auto 0 0 0; width: auto; height: 46%; border-left: 0; border-top: 1px solid var(--parkade-hair);
  }
  :host(.phone) .side, :host(.rails) .side { display: none; }
  :host(.rails) { inset: 0 57px 0 auto; width: 360px; z-index: 30; }
  :host(.rails) header { gap: 2px; padding-block: 2px 4px; }
  :host(.rails) footer { padding-block: 3px; }
  :host(.rails) :is(th, td), :host(.phone) :is(th, td) { padding-inline: 3px; }
  :host(.rails) :is(th, td):first-child, :host(.phone) :is(th, td):first-child { padding-left: 14px; }
  :host(.rails) :is(th, td):last-child, :host(.phone) :is(th, td):last-child { padding-right: 10px; }
  :host(.rails) thead th:first-child { width: 17%; }
  :host(.rails) thead th:last-child { width: 21%; }
  :host(.phone[opened]), :host(.rails[opened]) {
    width: auto; height: auto; padding: 0; border: 1px solid var(--parkade-hair);
    border-radius: calc(10px * var(--parkade-radius)); box-shadow: var(--parkade-float);
    background: var(--parkade-raise);
  }
  :host(.phone[opened]) { inset: 106px 8px auto auto; }
  :host(.rails[opened]) { inset: 8px 66px auto auto; }
  @container (max-width: 960px) {
    :host([opened]:not(.phone, .rails)) {
      inset: 96px 12px auto auto; width: auto; height: auto; padding: 0; border: 1px solid var(--parkade-hair);
      border-radius: calc(10px * var(--parkade-radius)); box-shadow: var(--parkade-float);
      background: var(--parkade-raise);
    }
  }
`;
