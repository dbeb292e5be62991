import { css } from "lit";

/** The chip over an embedded playground's map until somebody edits it. */
export const chip = css`
  .edit {
    position: absolute; z-index: 3; right: 12px; top: 44px; height: 32px; padding: 0 14px; border-radius: 16px;
    font-weight: 600; color: var(--parkade-accent);
    background: color-mix(in srgb, var(--parkade-panel) 94%, transparent); border: 1px solid var(--parkade-hair2);
    box-shadow: var(--parkade-float); cursor: pointer;
  }
  :host([controls="full"]) .edit { top: 93px; }
  @container (width > 960px) { :host([controls="full"]) .edit { right: 292px; } }
  @media (pointer: coarse) { .edit { height: 44px; border-radius: 22px; } }
`;
