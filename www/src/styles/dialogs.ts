import { css } from "lit";

export const dialogs = css`
  dialog {
    width: min(var(--dialog-width, 640px), 94vw); border: 0; padding: 0; color: var(--parkade-t1);
    background: var(--parkade-raise); border-radius: calc(14px * var(--parkade-radius));
    box-shadow: var(--parkade-lift); overflow: hidden; max-height: min(760px, 92vh); max-height: min(760px, 92dvh);
  }
  dialog[open] { display: flex; flex-direction: column; animation: rise var(--parkade-slow) var(--parkade-ease); }
  @keyframes rise { from { opacity: 0; transform: translateY(8px); } }
  dialog::backdrop { background: rgb(20 22 26 / .38); }
  .top { display: flex; align-items: center; gap: 14px; padding: 16px 16px 14px 24px; }
  .top h2 { margin: 0; font-size: 17px; line-height: 24px; font-weight: 600; letter-spacing: -0.015em; }
  .top p { margin: 0; color: var(--parkade-t2); }
  .top .icon { margin-left: auto; }
  .scroll { overflow-y: auto; padding: 2px 24px 24px; overscroll-behavior: contain; }
  @media (max-width: 640px) {
    dialog {
      width: 100%; max-width: 100%; margin: auto 0 0; padding-bottom: env(safe-area-inset-bottom);
      border-radius: calc(14px * var(--parkade-radius)) calc(14px * var(--parkade-radius)) 0 0;
    }
    .top { padding: 14px 10px 10px 16px; gap: 10px; flex-wrap: wrap; }
    .top p { order: 3; width: 100%; }
    .scroll { padding: 2px 16px 16px; }
  }
`;
