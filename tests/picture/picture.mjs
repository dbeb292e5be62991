// Pictures of the documents, of the page in dist/; `cargo xtask picture` builds it first.
import { fileURLToPath } from "node:url";
import { withBrowser } from "../e2e/browser.js";
import { photographLots } from "./lots.mjs";
import { photographQuestions } from "./questions.mjs";

const FILE = fileURLToPath(new URL("../../docs/public/playground.png", import.meta.url));

await withBrowser(async (browser, url) => {
  // README's: as a visitor meets it, once all planners have answered and been timed.
  const page = await browser.newPage({
    viewport: { width: 1400, height: 900 },
    colorScheme: "light",
    reducedMotion: "reduce",
  });
  await page.goto(url);
  await page.evaluate(() => document.querySelector("parkade-playground").settled());
  await page.waitForFunction(isAtRest);
  await page.screenshot({ path: FILE });
  console.log(FILE);
  await photographQuestions(browser, url);
  await photographLots(browser, url);
});

/** Runs in the page: every planner is loaded and timed, and no better path is looked for any more. */
function isAtRest() {
  const { complete, improving, choices, results } = document.querySelector("parkade-playground").store.state;
  return complete && !improving && choices?.hybrid !== undefined && Object.values(results).every(({ time }) => time);
}
