/** A paper's claims, each with its verdict in a word and what we find in a sentence. */
import type { PaperClaim } from "parkade";
import { css, html, type TemplateResult } from "lit";
import { number, templateOf, type Lang } from "../i18n/index";
import messages from "../i18n/messages/claims.json";
import { translator } from "../i18n/translator";
import { icon, type IconName } from "../styles/icons";
import { foundText } from "../texts/claims";
import { say } from "./papers-messages";

const claimed = translator("claim", messages);

const VERDICT: Record<PaperClaim["holds"], { tone: string; icon: IconName }> = {
  yes: { tone: "", icon: "check" },
  partly: { tone: "warn", icon: "warning" },
  no: { tone: "err", icon: "close" },
  unknown: { tone: "quiet", icon: "clock" },
};

/** The claim and what is found here. */
export const sentencesOf = (lang: Lang, claim: PaperClaim): [text: string, found: string] => [
  claimed(lang, `${claim.id}.text`),
  foundText(claim, {
    template: templateOf(lang, `claim.${claim.id}.found`),
    range: templateOf(lang, "claim.range"),
    missing: claimed(lang, "missing"),
    number: (value, digits) => number(lang, value, digits),
  }),
];

export const claimStyles = css`
  .claims { list-style: none; margin: 0; padding: 0; font-size: 12.5px; line-height: 17px; }
  .claims li {
    display: grid; grid-template-columns: 130px 1fr; gap: 2px 12px; padding: 6px 0;
    border-top: 1px solid var(--parkade-hair); align-items: start;
  }
  .claims .chip { justify-self: start; }
  .claims p { margin: 2px 0 0; color: var(--parkade-t2); }
  @media (max-width: 640px) { .claims li { grid-template-columns: 1fr; } }
`;

export function verdictChip(lang: Lang, holds: PaperClaim["holds"]): TemplateResult {
  const { tone, icon: name } = VERDICT[holds];
  return html`<span class="chip ${tone}">${icon(name, 12)}<span>${say(lang, holds)}</span></span>`;
}

export const claimList = (lang: Lang, claims: readonly PaperClaim[]): TemplateResult =>
  html`<h3>${say(lang, "claims")}</h3><ul class="claims">${claims.map((claim) => {
    const [text, found] = sentencesOf(lang, claim);
    return html`<li id=${claim.id}>${verdictChip(lang, claim.holds)}<div>${text}<p>${found}</p></div></li>`;
  })}</ul>`;

export const claimsMarkdown = (lang: Lang, claims: readonly PaperClaim[]): string[] => [
  `### ${say(lang, "claims")}`,
  "",
  "| | | |",
  "| --- | --- | --- |",
  ...claims.map((one) => {
    const [text, found] = sentencesOf(lang, one);
    return `| ${text} | **${say(lang, one.holds)}** | ${found} |`;
  }),
  "",
];
