import { css } from "lit";

const dark = css`
  color-scheme: dark;
  --parkade-app: #0e1013; --parkade-panel: #15181c; --parkade-bg: #15181c;
  --parkade-floor: var(--parkade-bg); --parkade-out: #0b0d0f;
  --parkade-raise: #1f2329; --parkade-hover: #20252b; --parkade-press: #2a3037;
  --parkade-hair: #272c33; --parkade-hair2: #3a414a; --parkade-gridl: #1b1f24;
  --parkade-fg: #eceef0; --parkade-t1: var(--parkade-fg); --parkade-t2: #a9b0b8; --parkade-t3: #8b929b;
  --parkade-accent: #9a97ff; --parkade-accent-soft: #26264a;
  --parkade-obstacle: #4c535c; --parkade-obs: var(--parkade-obstacle);
  --parkade-obs-edge: #a3aab3; --parkade-parked: #343a42;
  --parkade-slot: #858c95; --parkade-arrow: #a2a9b2;
  --parkade-err: #ff8a80; --parkade-err-soft: #3a1f1e; --parkade-warn: #e8b45a; --parkade-warn-soft: #332915;
  --parkade-float: 0 1px 2px rgb(0 0 0 / .4), 0 4px 16px rgb(0 0 0 / .4);
  --parkade-lift: 0 2px 6px rgb(0 0 0 / .4), 0 16px 48px rgb(0 0 0 / .6);
`;

const light = css`
  color-scheme: light;
  --parkade-app: #f4f4f2; --parkade-panel: #ffffff; --parkade-bg: #ffffff;
  --parkade-floor: var(--parkade-bg); --parkade-out: #ecece9;
  --parkade-raise: #ffffff; --parkade-hover: #f0f0ed; --parkade-press: #e6e6e2;
  --parkade-hair: #e3e3df; --parkade-hair2: #cfcfca; --parkade-gridl: #f1f1ee;
  --parkade-fg: #1b1d20; --parkade-t1: var(--parkade-fg); --parkade-t2: #565b62; --parkade-t3: #64696f;
  --parkade-accent: #4b45d6; --parkade-accent-soft: #ecebfc;
  --parkade-obstacle: #b4b8be; --parkade-obs: var(--parkade-obstacle);
  --parkade-obs-edge: #3f444b; --parkade-parked: #d5d8dc;
  --parkade-slot: #7d838b; --parkade-arrow: #5f666f;
  --parkade-err: #b3261e; --parkade-err-soft: #fbecea; --parkade-warn: #8a5300; --parkade-warn-soft: #fbf1e0;
  --parkade-float: 0 1px 2px rgb(20 22 26 / .06), 0 4px 16px rgb(20 22 26 / .10);
  --parkade-lift: 0 2px 6px rgb(20 22 26 / .08), 0 16px 48px rgb(20 22 26 / .18);
`;

/** Colours, type and motion; set once on the outer element and inherited by every shadow root inside. */
export const tokens = css`
  :host {
    ${light}
    --parkade-planner-1: #0072b2;
    --parkade-planner-2: #d55e00;
    --parkade-planner-3: #009e73;
    --parkade-planner-4: #cc79a7;
    --parkade-planner-5: #6a6a6a;
    --parkade-planner-6: #8c6d00;
    --parkade-radius: 1;
    --parkade-scrim: rgb(20 22 26 / .38);
    --parkade-ease: cubic-bezier(.2, 0, 0, 1);
    --parkade-fast: 120ms;
    --parkade-mid: 160ms;
    --parkade-slow: 220ms;
    font: 400 13px/18px var(--parkade-font, system-ui, -apple-system, "Segoe UI", Roboto, "PingFang SC",
      "Microsoft YaHei", "Noto Sans SC", sans-serif);
    color: var(--parkade-t1);
    background: var(--parkade-app);
    -webkit-text-size-adjust: 100%;
  }
  :host([theme="dark"]) { ${dark} }
  @media (prefers-color-scheme: dark) {
    :host(:not([theme="light"])) { ${dark} }
  }
  @media (prefers-reduced-motion: reduce) {
    :host { --parkade-fast: 0ms; --parkade-mid: 0ms; --parkade-slow: 0ms; }
  }
`;
