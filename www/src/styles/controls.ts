import { css } from "lit";

/** Buttons, fields, segmented controls and chips, shared by every panel. */
export const controls = css`
  *, *::before, *::after { box-sizing: border-box; }
  [hidden] { display: none !important; }
  :host { font-variant-numeric: tabular-nums; }
  :focus { outline: none; }
  :focus-visible {
    outline: 2px solid var(--parkade-accent); outline-offset: 2px; border-radius: calc(6px * var(--parkade-radius));
  }
  svg { display: block; flex: none; }
  svg .fill { fill: currentColor; }
  .visually-hidden {
    position: absolute; width: 1px; height: 1px; margin: -1px; overflow: hidden;
    clip-path: inset(50%); white-space: nowrap;
  }
  button, select, input { font: inherit; color: inherit; letter-spacing: inherit; }
  button {
    appearance: none; border: 0; background: none; padding: 0; margin: 0; cursor: pointer;
    display: inline-flex; align-items: center; justify-content: center; gap: 6px; white-space: nowrap;
    border-radius: calc(6px * var(--parkade-radius)); -webkit-tap-highlight-color: transparent;
    transition: background-color var(--parkade-fast) var(--parkade-ease), color var(--parkade-fast) var(--parkade-ease);
  }
  button:disabled { opacity: .38; cursor: default; }
  .icon { width: 32px; height: 32px; color: var(--parkade-t2); }
  .icon.small { width: 26px; height: 26px; }
  .button { height: 32px; padding: 0 10px; font-weight: 500; }
  .icon:hover:enabled, .button:hover:enabled { background: var(--parkade-hover); color: var(--parkade-t1); }
  .icon:active:enabled, .button:active:enabled { background: var(--parkade-press); }
  .outline { border: 1px solid var(--parkade-hair2); background: var(--parkade-panel); }
  .solid { background: var(--parkade-t1); color: var(--parkade-panel); padding: 0 12px; }
  .solid:hover:enabled { background: var(--parkade-t1); color: var(--parkade-panel); opacity: .88; }
  .solid:active:enabled { background: var(--parkade-t1); opacity: .76; }
  .link { color: var(--parkade-t2); height: 24px; padding: 0 6px; margin: 0 -6px; }
  .link:hover:enabled { color: var(--parkade-t1); background: var(--parkade-hover); }

  .segmented {
    display: inline-flex; padding: 2px; gap: 0; background: var(--parkade-hover);
    border-radius: calc(6px * var(--parkade-radius));
  }
  .segmented button {
    height: 24px; padding: 0 10px; border-radius: calc(4px * var(--parkade-radius)); color: var(--parkade-t2);
    font-weight: 500; border: 1px solid transparent;
  }
  .segmented button:hover { color: var(--parkade-t1); }
  .segmented button[aria-pressed="true"], .segmented button[aria-checked="true"],
  .segmented button[aria-selected="true"] {
    background: var(--parkade-raise); color: var(--parkade-t1); border-color: var(--parkade-hair2);
  }

  .chip {
    display: inline-flex; align-items: center; gap: 5px; height: 20px; padding: 0 8px; border-radius: 999px;
    min-width: 0;
    font-size: 12px; line-height: 16px; font-weight: 500; background: var(--parkade-hover); color: var(--parkade-t1);
  }
  .chip > span { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
  .chip svg { width: 12px; height: 12px; }
  .chip.err { background: var(--parkade-err-soft); color: var(--parkade-err); }
  .chip.warn { background: var(--parkade-warn-soft); color: var(--parkade-warn); }
  .chip.quiet { color: var(--parkade-t2); }

  .field {
    display: inline-flex; align-items: center; gap: 4px; height: 28px; padding: 0 8px; background: var(--parkade-panel);
    border: 1px solid var(--parkade-hair2); border-radius: calc(6px * var(--parkade-radius)); min-width: 0;
  }
  .field:focus-within { border-color: var(--parkade-accent); box-shadow: inset 0 0 0 1px var(--parkade-accent); }
  .field > span { color: var(--parkade-t3); font-size: 12px; flex: none; }
  .field input {
    border: 0; background: none; min-width: 0; width: 100%; text-align: right; padding: 0; outline: none;
    font-variant-numeric: tabular-nums; appearance: textfield; -moz-appearance: textfield;
  }
  .field input::-webkit-inner-spin-button { display: none; }
  .unit { color: var(--parkade-t3); }
  .keys { color: var(--parkade-t3); font-size: 12px; line-height: 16px; }

  .popover {
    position: fixed; inset: auto; margin: 0; min-width: 200px; max-height: calc(100vh - 64px);
    max-height: calc(100dvh - 64px); overflow-y: auto; padding: 6px; background: var(--parkade-raise);
    color: var(--parkade-t1);
    border: 1px solid var(--parkade-hair); border-radius: calc(10px * var(--parkade-radius));
    box-shadow: var(--parkade-float);
    animation: appear var(--parkade-mid) var(--parkade-ease);
  }
  @keyframes appear { from { opacity: 0; transform: translateY(-4px); } }
  .popover .item {
    display: flex; width: 100%; justify-content: flex-start; gap: 10px; min-height: 32px; padding: 0 10px;
    text-align: left;
  }
  .popover .item:hover:enabled, .popover .item:focus-visible { background: var(--parkade-hover); }
  .popover .item > .keys { margin-left: auto; }
  .popover .item svg { color: var(--parkade-t2); }
  .popover hr { border: 0; border-top: 1px solid var(--parkade-hair); margin: 6px 0; }
  .popover h3 { margin: 6px 10px 4px; font-size: 12px; line-height: 16px; font-weight: 500; color: var(--parkade-t3); }

  .slider {
    position: relative; display: block; width: 100%; height: 20px; margin: 0; appearance: none; background: none;
    cursor: pointer;
  }
  .slider::-webkit-slider-runnable-track {
    height: 2px; border-radius: 1px;
    background: linear-gradient(to right, var(--parkade-t1) var(--at, 0%), var(--parkade-hair2) var(--at, 0%));
  }
  .slider::-moz-range-track { height: 2px; border-radius: 1px; background: var(--parkade-hair2); }
  .slider::-moz-range-progress { height: 2px; border-radius: 1px; background: var(--parkade-t1); }
  .slider::-webkit-slider-thumb {
    appearance: none; width: 14px; height: 14px; margin-top: -6px; border-radius: 50%; background: var(--parkade-panel);
    border: 1.25px solid var(--parkade-t1);
  }
  .slider::-moz-range-thumb {
    width: 12px; height: 12px; border-radius: 50%; background: var(--parkade-panel);
    border: 1.25px solid var(--parkade-t1);
  }
  .slider:active::-webkit-slider-thumb { border-color: var(--parkade-accent); border-width: 2px; }

  @media (pointer: coarse) {
    .icon, .button, .popover .item { min-height: 44px; }
    .icon { min-width: 44px; }
    .slider { height: 44px; }
  }
  @media (forced-colors: active) {
    .slider::-webkit-slider-runnable-track { background: CanvasText; }
    .slider::-moz-range-track { background: CanvasText; }
    .slider::-webkit-slider-thumb { background: Canvas; border: 2px solid CanvasText; }
    .slider:focus-visible::-webkit-slider-thumb { border-color: Highlight; }
    button[aria-pressed="true"], button[aria-checked="true"] {
      forced-color-adjust: none; background: Highlight; color: HighlightText;
    }
  }
`;
