// Random clicks, keys and touches on a desktop, a phone and an embedded page at once: `cargo xtask endurance monkey
// [minutes] [seed]`. Nothing may be said on the console, no text may read NaN, and a scene is planned at the end.
import { withBrowser } from "../e2e/browser.js";
import { watchTurns } from "./damaged-page.mjs";
import { monkey } from "./monkey-page.mjs";
import { random } from "./random.mjs";

const minutes = Number(process.argv[2] ?? 10),
  seed = Number(process.argv[3] ?? 1);
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

await withBrowser(async (browser, url) => {
  console.log(`Chromium ${browser.version()}, ${minutes} minutes, seed ${seed}`);
  const trial = async (name, options, hash, how) => {
    const context = await browser.newContext({ serviceWorkers: "block", ...options }),
      page = await context.newPage();
    await page.addInitScript(watchTurns);
    await page.goto(hash);
    await page.waitForTimeout(2000);
    const end = performance.now() + minutes * 60_000;
    const found = await monkey(page, random(how.seed), {
      ...how,
      frame: () => page.frames().at(-1),
      enough: () => performance.now() > end,
    });
    console.log(
      `${name}, seed ${how.seed}: ${found.actions} actions, ${found.complaints.length} complaints, longest ` +
        `turn ${found.slowest.toFixed(0)} ms, ${found.usable ? "plans afterwards" : "NO PLANS AFTERWARDS"}`,
    );
    for (const { text, action, before } of found.complaints.slice(0, 5))
      console.log(`after ${action} actions: ${text.slice(0, 1500)}\n  ${before.join("\n  ")}`);
    if (found.complaints.length > 0 || !found.usable) process.exitCode = 1;
    await context.close();
  };
  const host = new URL(
    `/host/frame.html?hash=${encodeURIComponent("layout=grid&controls=full&editable")}`,
    url.replace("127.0.0.1", "localhost"),
  ).href;
  await Promise.all([
    trial("desktop", { viewport: { width: 1400, height: 900 } }, url, { seed }),
    trial("phone", PHONE, url, { seed: seed + 1, touch: true }),
    trial("embedded", { viewport: { width: 1000, height: 700 } }, host, { seed: seed + 2 }),
  ]);
});
