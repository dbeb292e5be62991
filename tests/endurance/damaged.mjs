// Damaged links, messages and stored states: `cargo xtask endurance damaged [count] [seed]`. All of them through what
// reads them, one in twenty through the page itself. None may throw what nobody catches, hold a frame for two seconds,
// or leave the page without plans.
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { withBrowser } from "../e2e/browser.js";
import { complaintsOf, damagedLinks, damagedMessages, damagedStores, ready, watchTurns } from "./damaged-page.mjs";
import { random } from "./random.mjs";

const count = Number(process.argv[2] ?? 100_000),
  seed = Number(process.argv[3] ?? 1);
const vitest = fileURLToPath(new URL("../../node_modules/vitest/vitest.mjs", import.meta.url));
const readers = spawnSync(process.execPath, [vitest, "run", "tests/js/damaged.test.ts"], {
  env: { ...process.env, PARKADE_DAMAGED: `${count}:${seed}` },
  stdio: "inherit",
  cwd: fileURLToPath(new URL("../..", import.meta.url)),
});
if (readers.status !== 0) process.exitCode = 1;

const share = (part) => Math.max(1, Math.round((count / 20) * part));
await withBrowser(async (browser, url) => {
  console.log(`Chromium ${browser.version()}, one in twenty through the page, seed ${seed}`);
  const trial = async (name, address, run) => {
    const page = await browser.newPage({
      viewport: { width: 1400, height: 900 },
      reducedMotion: "reduce",
      serviceWorkers: "block",
    });
    await page.addInitScript(watchTurns);
    const complaints = complaintsOf(page),
      from = performance.now();
    await page.goto(address);
    const found = await run(page);
    const minutes = (performance.now() - from) / 60_000;
    console.log(
      `${name}: ${found.tried} tried in ${minutes.toFixed(1)} minutes, longest ` +
        `turn ${found.slowest.toFixed(0)} ms, ${found.lost.length} lost, ${complaints.length} complaints`,
    );
    for (const one of found.lost.slice(0, 3)) console.log("lost:", JSON.stringify(one).slice(0, 2000));
    for (const text of [...new Set(complaints)].slice(0, 5)) console.log("the page complained:", text);
    if (found.lost.length + complaints.length > 0) process.exitCode = 1;
    await page.close();
  };
  const inPage = (run) => async (page) => {
    await ready(page);
    return run(page);
  };
  await trial(
    "scenes in links",
    url,
    inPage((page) => damagedLinks(page, random(seed), share(0.35), false)),
  );
  await trial(
    "views in links",
    url,
    inPage((page) => damagedLinks(page, random(seed + 1), share(0.3), true)),
  );
  await trial("messages", new URL("/host/frame.html", url.replace("127.0.0.1", "localhost")).href, (page) =>
    damagedMessages(page, random(seed + 2), share(0.33)),
  );
  await trial(
    "stored states",
    url,
    inPage((page) => damagedStores(page, random(seed + 3), share(0.02))),
  );
});
