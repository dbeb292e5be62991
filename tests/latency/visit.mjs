// How soon does a first visit over a slow network see the picture, and the first live plan? `cargo xtask latency`
// builds dist/ first. The network is DevTools' "Fast 3G"; files come compressed, as static hosts serve them. Nothing
// here fails on a slow machine.
import { withBrowser } from "../e2e/browser.js";
import { serve } from "../e2e/server.js";
import { quantile } from "../quantile.mjs";

const RUNS = 5;
const NETWORK = { offline: false, latency: 150, downloadThroughput: 1.6e6 / 8, uploadThroughput: 750e3 / 8 };
const TARGETS = { picture: 1500, plan: 4000 };
const PATIENCE_MS = 60_000;

await withBrowser(async (browser) => {
  const { url, close } = await serve(0, { gzip: true });
  for (const [name, width, height] of [
    ["desk", 1400, 900],
    ["phone", 390, 844],
  ]) {
    const runs = [];
    while (runs.length < RUNS) runs.push(await visit(browser, url, { width, height }));
    const middle = (key) =>
      quantile(
        runs.map((run) => run[key]),
        0.5,
      );
    console.log(`\nfirst visit at 1.6 Mbit/s, 150 ms, ${name}: medians of ${RUNS}`);
    for (const [key, target] of Object.entries(TARGETS))
      console.log(
        `  first ${key.padEnd(10)} ${middle(key).toFixed(0)} ms; target ${target} ms: ${
          middle(key) <= target ? "met" : "missed"
        }`,
      );
    console.log(`  layout shift     ${middle("shift").toFixed(4)}`);
    console.log(`  until the plan   ${middle("requests")} requests, ${(middle("bytes") / 1000).toFixed(0)} kB`);
  }
  close();
});

async function visit(browser, url, viewport) {
  const context = await browser.newContext({ viewport }),
    page = await context.newPage();
  const session = await context.newCDPSession(page);
  await session.send("Network.enable");
  await session.send("Network.emulateNetworkConditions", NETWORK);
  let requests = 0,
    bytes = 0;
  session.on("Network.loadingFinished", ({ encodedDataLength }) => {
    requests++;
    bytes += encodedDataLength;
  });
  await page.addInitScript(watch);
  await page.goto(url);
  await page.waitForFunction(() => window.visit.plan, null, { timeout: PATIENCE_MS, polling: 50 });
  const seen = { requests, bytes, ...(await page.evaluate(() => window.visit)) };
  await context.close();
  return seen;
}

/**
 * Runs in the page: notes the first picture (the poster, or else the first paint), the first plan that is there, and
 * what moves.
 */
function watch() {
  window.visit = { shift: 0 };
  new PerformanceObserver((list) => {
    for (const { value } of list.getEntries()) window.visit.shift += value;
  }).observe({ type: "layout-shift", buffered: true });
  new PerformanceObserver((list) => {
    for (const { name, startTime } of list.getEntries())
      if (name === "first-contentful-paint") window.visit.picture = startTime;
  }).observe({ type: "paint", buffered: true });
  const look = () => {
    const results = Object.values(document.querySelector("parkade-playground")?.store?.state.results ?? {});
    if (results.some(({ plan }) => plan))
      requestAnimationFrame((now) => {
        window.visit.plan = now;
      });
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}
