// A page of dist/ in headless Chromium, for what takes longer than a test may.
import { withBrowser } from "../e2e/browser.js";

/** A module's memory is reachable only where it is made: workers are told to keep theirs. */
const KEEP_MEMORIES =
  `globalThis.memories = []; const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...all) => { const made = await instantiate(...all); memories.push((made.instance ` +
  `?? made).exports.memory); return made; };`;

/** Calls `use` with the loaded page of that size; closes everything after it. */
export async function withPage(use, prepare, viewport = { width: 1400, height: 900 }) {
  return withBrowser(async (browser, url) => {
    const page = await browser.newPage({ viewport, reducedMotion: "reduce", serviceWorkers: "block" });
    await page.route(/worker.*\.js$/, async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `${KEEP_MEMORIES}\n${await response.text()}` });
    });
    const complaints = [];
    page.on("console", (message) => {
      if (message.type() === "error") complaints.push(message.text());
    });
    page.on("pageerror", (error) => complaints.push(error.message));
    if (prepare) await page.addInitScript(prepare);
    await page.goto(url);
    await page.evaluate(async () => {
      await customElements.whenDefined("parkade-playground");
      const element = document.querySelector("parkade-playground");
      await element.ready;
      await element.app.complete();
      await element.settled();
    });
    await use(page, browser.version());
    for (const text of new Set(complaints)) console.log(`the page complained: ${text}`);
    return complaints.length === 0;
  }, "--js-flags=--expose-gc");
}
