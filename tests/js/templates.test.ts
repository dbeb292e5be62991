import { parseAst } from "rolldown/parseAst";
import { expect, it } from "vitest";
import { squeezeTemplates } from "../../vite.templates";

const squeeze = squeezeTemplates.transform as unknown as (code: string, id: string) => string | null;
const squeezed = (code: string): string | null =>
  squeeze.call({ parse: (text: string) => parseAst(text, { lang: "ts" }) }, code, "/repository/www/src/panel.ts");

it("squeezes markup, also in templates within templates, and leaves every other text", () => {
  const code =
    'const a: number = 1, b = html`<p\n    .x=${a}>\n  ${a ? html`<b>\n\n  ${`\n  ${a}`}</b>` : ""}</p>`; // `';
  expect(squeezed(code)).toBe(
    'const a: number = 1, b = html`<p .x=${a}> ${a ? html`<b> ${`\n  ${a}`}</b>` : ""}</p>`; // `',
  );
});

it("squeezes styles without their comments", () => {
  const code =
    "const s = css`\n  /* Why: so. */\n  .a > .b, i { left: 0.5px; top: ${x}px; color: #aabbcc; grid-row: 1 / -1; " +
    "}\n`;";
  expect(squeezed(code)).toBe("const s = css`\n.a>.b,i{left:.5px;top:${x}px;color:#abc;grid-row:1/-1}`;");
});
