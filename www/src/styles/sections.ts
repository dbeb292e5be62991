import { css } from "lit";

/** Headings and rows of the inspector's sections. */
export const sections = css`
  :host { display: block; }
  .head { display: flex; align-items: center; gap: 8px; min-height: 24px; margin-bottom: 8px; }
  h2 { margin: 0; font: inherit; font-weight: 600; display: flex; align-items: center; gap: 8px; min-width: 0; }
  .head > :last-child:not(:first-child) { margin-left: auto; color: var(--parkade-t2); }
  p { margin: 0; color: var(--parkade-t2); font-size: 12px; line-height: 16px; }
  .row { display: flex; gap: 6px; align-items: center; }
  .row + .row, .row + p, p + .row { margin-top: 8px; }
  .row .field { flex: 1; gap: 3px; padding: 0 5px; }
  .to-end { margin-left: auto; }
`;
