import { css, unsafeCSS } from "lit";
import { tokens } from "../styles/tokens";

/**
 * The colours by the scheme that `Embedded` writes on the outer element; the reader's own setting is one of the things
 * it follows.
 */
export const colours = css`${unsafeCSS(
  tokens.cssText
    .replace(/:not\(\[theme="?light"?\]\)/, ":not(*)")
    .replace(/\[theme="?dark"?\]/, '[data-scheme="dark"]'),
)}`;
