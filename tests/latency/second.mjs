// What does a second playground cost a page that has one? Processor time of the page's main thread, which other
// programs disturb less than the clock; `cargo xtask latency` builds dist/ first. Nothing here fails on a slow machine.
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { withBrowser } from "../e2e/browser.js";
import { quantile } from "../quantile.mjs";

const RUNS = 7;
const TARGET = 30;
const STEPS = { frame: "first frame of the map", ready: "`ready`", shown: "poster gone, panels built" };
/** The first one is planned, timed and complete by then. */
const REST_MS = 4000;

const folder = mkdtempSync(join(tmpdir(), "parkade-"));
try {
  await withBrowser(measure);
} finally {
  rmSync(folder, { recursive: true });
}

async function measure(browser, url) {
  for (const [controls, width, height] of [
    ["minimal", 720, 420],
    ["full", 720, 420],
    ["full", 1280, 720],
  ]) {
    const runs = [];
    while (runs.length < RUNS) runs.push(await second(browser, url, controls, width, height));
    console.log(
      `\nsecond playground, controls="${controls}", ${width} x ${height}: main thread's processor time from its ` +
        `insertion, medians of ${RUNS}`,
    );
    for (const [step, name] of Object.entries(STEPS)) {
      const [low, middle, high] = [0, 0.5, 1].map((share) =>
        quantile(
          runs.map((run) => run[step]),
          share,
        ),
      );
      const verdict = step === "shown" ? "" : `; target ${TARGET} ms: ${middle <= TARGET ? "met" : "missed"}`;
      console.log(`  ${name.padEnd(28)} ${middle.toFixed(1)} ms (${low.toFixed(1)} to ${high.toFixed(1)})${verdict}`);
    }
  }
}

/** Milliseconds to each step. */
async function second(browser, url, controls, width, height) {
  const page = await browser.newPage({
    viewport: { width: width + 40, height: 2 * height + 60 },
    reducedMotion: "reduce",
  });
  await page.route("**/second.html", (route) =>
    route.fulfill({
      contentType: "text/html",
      body:
        `<!doctype html><style>parkade-playground { width: ${width}px; height: ${height}px }</style>
    <script type="module" src="parkade-playground.js"></script><parkade-playground layout="overlay" ` +
        `controls="${controls}" loading="eager"></parkade-playground>`,
    }),
  );
  await page.goto(`${url}second.html`);
  await page.evaluate(async (rest) => {
    await customElements.whenDefined("parkade-playground");
    await document.querySelector("parkade-playground").ready;
    await new Promise((done) => setTimeout(done, rest));
  }, REST_MS);
  const path = join(folder, "trace.json");
  await browser.startTracing(page, { path, categories: ["blink.user_timing"] });
  await page.evaluate(insert);
  await browser.stopTracing();
  await page.close();
  const events = JSON.parse(readFileSync(path, "utf8")).traceEvents;
  const at = (name) =>
    events.find((event) => event.name === `second-${name}` && event.cat.includes("user_timing"))?.tts ?? NaN;
  return Object.fromEntries(Object.keys(STEPS).map((step) => [step, (at(step) - at("from")) / 1000]));
}

/** Runs in the page. */
async function insert() {
  const mark = (name) => performance.mark(`second-${name}`);
  /** After the frame in which everything scheduled until now is painted. */
  const painted = () =>
    new Promise((done) =>
      requestAnimationFrame(() => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = done;
        port2.postMessage(null);
      }),
    );
  const first = document.querySelector("parkade-playground"),
    other = first.cloneNode();
  const started = new Promise((done) => other.addEventListener("plan-start", done, { once: true }));
  await painted();
  mark("from");
  first.before(other);
  const drawn = started.then(painted).then(() => mark("frame"));
  await other.ready;
  mark("ready");
  await drawn;
  while (other.shadowRoot.querySelector(".poster")) await painted();
  await painted();
  mark("shown");
}
