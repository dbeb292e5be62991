// Damaged links, messages and stored states against the page in a browser. Each trial gives what it found: frozen
// frames and lost pages.
import { damagedMessage, damagedScene, damagedStore, damagedView, sceneText, shortForm } from "./damage.mjs";

const BATCH = 50;
/** A frame that takes longer than this is frozen, if it does so again alone: the machine may have been busy. */
const FROZEN_MS = 2000;
/** Plans of a damaged scene may be long searches. */
const PATIENCE_MS = 60_000;

/** Everything the page complains about. */
export function complaintsOf(page) {
  const complaints = [];
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.stack ?? error.message));
  page.on("crash", () => complaints.push("the page crashed"));
  return complaints;
}

/**
 * Runs in the page or frame before anything else: the longest time without a turn of the event loop, since last asked.
 */
export function watchTurns() {
  let last = performance.now(),
    longest = 0;
  setInterval(() => {
    const now = performance.now();
    longest = Math.max(longest, now - last);
    last = now;
  }, 20);
  window.longestTurn = () => {
    const told = Math.max(longest, performance.now() - last);
    longest = 0;
    return told;
  };
}

/** What the trials do in the page: `document.querySelector("parkade-playground")`, ready and with every planner. */
export const ready = (page) =>
  page.evaluate(async () => {
    await customElements.whenDefined("parkade-playground");
    const element = document.querySelector("parkade-playground");
    await element.ready;
    await (element.app?.complete() ?? element.settled());
    await element.settled();
  });

/** Gives the page a sound scene with its own view and waits for its plans: their hashes, or what went wrong. */
const usable = (page, scene) =>
  page.evaluate(
    async ([sound, patience]) => {
      const element = document.querySelector("parkade-playground");
      element.store.set({
        planners: ["four", "eight", "risk-field", "hybrid"],
        focus: "hybrid",
        mode: "grid",
        camera: null,
        message: null,
      });
      element.sceneData = sound;
      const settled = await Promise.race([
        element.settled().then(() => true),
        new Promise((done) => setTimeout(() => done(false), patience)),
      ]);
      return settled ? JSON.stringify(Object.values(element.results).map((plan) => plan?.hash)) : "no plans";
    },
    [scene, PATIENCE_MS],
  );

/** `count` changes of the address: scene parts, view parts, and both. */
export async function damagedLinks(page, next, count, views) {
  const address = await page.evaluate(
    async () => await document.querySelector("parkade-playground").app.links.address(true),
  );
  const [sound, view] = new URL(address).hash.slice("#s=".length).split("&v=");
  const scene = await page.evaluate(() => document.querySelector("parkade-playground").sceneData),
    short = await shortForm(sound);
  const before = await usable(page, scene),
    found = { tried: 0, slowest: 0, lost: [] };
  const play = (hashes) =>
    page.evaluate(async (all) => {
      const element = document.querySelector("parkade-playground");
      window.longestTurn();
      for (const hash of all) {
        location.hash = hash;
        await new Promise((done) => setTimeout(done, 25));
        element.store.set({ message: null });
      }
      // The last one's answer is waited for: what comes later than the sound scene would be taken for its plans.
      const { read } = element.app.links;
      for (let waited = 0; waited < 50; waited++) await new Promise((done) => setTimeout(done, 2));
      await read.call(element.app.links).catch(() => null);
      return window.longestTurn();
    }, hashes);
  while (found.tried < count) {
    const hashes = [];
    for (let i = 0; i < Math.min(BATCH, count - found.tried); i++) {
      const part = views
        ? next(4)
          ? sound
          : await sceneText({ ...short, n: `n${next(1e6)}` })
        : await damagedScene(next, sound, short);
      hashes.push(`s=${part}${views || next(4) === 0 ? `&v=${damagedView(next, view)}` : ""}`);
    }
    await judge(found, hashes, play);
    found.tried += hashes.length;
    const after = await usable(page, scene);
    if (after !== before) found.lost.push({ after, hashes });
  }
  return found;
}

/** Times a batch; what was slow is done again alone, and only counts if it is slow again. */
async function judge(found, inputs, play) {
  const longest = await play(inputs);
  if (longest <= FROZEN_MS) {
    found.slowest = Math.max(found.slowest, longest);
    return;
  }
  for (const input of inputs) {
    const alone = await play([input]);
    found.slowest = Math.max(found.slowest, alone);
    if (alone > FROZEN_MS && (await play([input])) > FROZEN_MS) found.lost.push({ frozen: alone, input });
  }
}

/** `count` messages to a frame of another origin. */
export async function damagedMessages(page, next, count) {
  await page.waitForFunction(() => window.heard?.some(({ type }) => type === "parkade:plan-complete"), null, {
    timeout: PATIENCE_MS,
  });
  const frame = page.frames()[1],
    found = { tried: 0, slowest: 0, lost: [] };
  const ask = (name, rest) =>
    page.evaluate(([what, more]) => window.ask(what, more).then(({ result }) => result), [name, rest]);
  const scene = await ask("getScene", {}),
    link = new URL(await ask("shareURL", {})).hash;
  const usableFrame = async () => {
    await ask("setScene", { args: [scene] });
    await ask("plan", {});
    return frame.evaluate(() =>
      JSON.stringify(Object.values(document.querySelector("parkade-playground").results).map((plan) => plan?.hash)),
    );
  };
  const before = await usableFrame();
  const play = async (messages) => {
    await frame.evaluate(() => window.longestTurn());
    await page.evaluate(async (all) => {
      window.heard.length = 0;
      const soon = () => new Promise((done) => setTimeout(done, 40));
      for (const { type, ...rest } of all) await Promise.race([window.ask(type, rest), soon()]);
      await soon();
    }, messages);
    return frame.evaluate(() => window.longestTurn());
  };
  while (found.tried < count) {
    const messages = Array.from({ length: Math.min(BATCH, count - found.tried) }, () =>
      damagedMessage(next, scene, link),
    );
    await judge(found, messages, play);
    found.tried += messages.length;
    const after = await usableFrame();
    if (after !== before) found.lost.push({ after, messages });
  }
  return found;
}

/** `count` reloads with something damaged in what the browser keeps. */
export async function damagedStores(page, next, count) {
  const scene = await page.evaluate(() => document.querySelector("parkade-playground").sceneData);
  const before = await usable(page, scene),
    found = { tried: 0, slowest: 0, lost: [] };
  for (; found.tried < count; found.tried++) {
    // Something to keep: two steps, one of them undone, and an address.
    await page.evaluate(
      async (shift) => {
        const { store, app } = document.querySelector("parkade-playground");
        for (const x of [shift, -shift])
          store.edit({ ...store.state.scene, start: { ...store.state.scene.start, x: store.state.scene.start.x + x } });
        store.undo();
        await app.links.write();
        dispatchEvent(new Event("pagehide"));
      },
      (1 + next(50)) / 100,
    );
    const kept = await page.evaluate(() =>
      [
        ...Object.entries(localStorage).map(([key, text]) => ["local", key, text]),
        ...Object.entries(sessionStorage).map(([key, text]) => ["session", key, text]),
        ["local", "parkade.theme", "dark"],
        ["local", "parkade.lang", "zh"],
        ["local", "parkade.pane.side", "300"],
        ["local", "parkade.hint.drag", "seen"],
        ["local", "parkade.tab.other", ""],
      ].filter(([, key]) => key.startsWith("parkade.")),
    );
    const tabs = kept
      .filter(([, key]) => key.startsWith("parkade.tab.") && key !== "parkade.tab.other")
      .map(([, , text]) => text);
    const sound = kept.map(([area, key, text]) => [area, key, key === "parkade.tab.other" ? (tabs[0] ?? "{}") : text]);
    const damaged = Array.from({ length: 1 + next(3) }, () => damagedStore(next, sound));
    await judge(found, [damaged], ([all]) => reloadWith(page, all));
    const after = await usable(page, scene);
    if (after !== before) found.lost.push({ after, damaged });
    await page.evaluate(() => {
      localStorage.clear();
    });
  }
  return found;
}

/** The longest turn of a start with this in the browser's stores. */
async function reloadWith(page, entries) {
  await page.evaluate((all) => {
    for (const [area, key, text] of all) (area === "local" ? localStorage : sessionStorage).setItem(key, text);
  }, entries);
  await page.reload();
  await ready(page);
  return page.evaluate(() => window.longestTurn());
}
