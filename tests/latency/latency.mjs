// How soon does the page in dist/ answer a drag? `cargo xtask latency` builds it first. Nothing here fails on a slow
// machine: times depend on the machine and on what else it does.
import { loadavg, availableParallelism } from "node:os";
import { withBrowser } from "../e2e/browser.js";
import { quantile } from "../quantile.mjs";

const STEPS = 200;
const TARGET = { grid: 60, hybrid: 100 };
/** Between the moves of the fast drag: a mouse that reports 125 times a second. */
const PACE_MS = 8;
/** A step without an answer after this long counts as this long. */
const PATIENCE_MS = 10_000;

await withBrowser(async (browser, url) => {
  const page = await browser.newPage({ viewport: { width: 1400, height: 900 }, reducedMotion: "reduce" });
  const metrics = await meter(page);
  await page.goto(url);
  await page.evaluate(installProbe);
  console.log(
    `\n${await page.evaluate(
      () => navigator.userAgent,
    )}; ${availableParallelism()} processors, load ${loadavg()[0]?.toFixed(1)}`,
  );
  await calm(page, metrics);
  await fast(page, "default scene, fast drag");
  await open(page, "narrow-gap");
  await fast(page, "narrow-gap, which hybrid searches long, fast drag");
});
await import("./second.mjs");
await import("./visit.mjs");

/** Each step waits until the one before is drawn. */
async function calm(page, metrics) {
  const at = await grab(page);
  const steps = [];
  const before = await metrics();
  for (let i = 1; i <= STEPS; i++) {
    await page.evaluate(() => window.probe.expect());
    await page.mouse.move(...at(i / STEPS));
    steps.push(await page.evaluate((patience) => window.probe.drawn(patience), PATIENCE_MS));
  }
  const after = await metrics();
  await page.mouse.up();
  console.log(
    `\ndefault scene, goal dragged by ${steps.length} moves, each after the last was drawn ` +
      `(${steps.filter((one) => one.found).length} with a hybrid path)`,
  );
  row(
    "pointer to all grid planners drawn",
    steps.map((one) => one.grid),
    TARGET.grid,
  );
  row(
    "pointer to hybrid drawn",
    steps.map((one) => one.hybrid),
    TARGET.hybrid,
  );
  const idle = idleFlips(steps.filter((one) => one.found));
  console.log(
    `leaps of hybrid's path to a way within 3 % of the length: ${idle}; target none: ${idle === 0 ? "met" : "missed"}`,
  );
  const each = (name) => ((1000 * (after[name] - before[name])) / steps.length).toFixed(1);
  console.log(
    `main thread, CPU time a ` +
      `step         ${each("TaskDuration")} ms: scripts ${each("ScriptDuration")}, style and layout ${(
        Number(each("RecalcStyleDuration")) + Number(each("LayoutDuration"))
      ).toFixed(1)}`,
  );
}

/** Answers more than a metre off the one before, although about as long. */
function idleFlips(steps) {
  const strays = (one, other) => {
    let most = 0;
    for (let i = 0; i < one.length; i += 3) {
      let least = Infinity;
      for (let j = 0; j < other.length; j += 3)
        least = Math.min(least, Math.hypot(one[i] - other[j], one[i + 1] - other[j + 1]));
      most = Math.max(most, least);
    }
    return most;
  };
  return steps.filter(
    (one, i) =>
      i > 0 && Math.abs(one.length / steps[i - 1].length - 1) < 0.03 && strays(one.path, steps[i - 1].path) > 1,
  ).length;
}

/** Sums of the main thread's CPU time by kind (s), which other programs disturb little. */
async function meter(page) {
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable", { timeDomain: "threadTicks" });
  return async () =>
    Object.fromEntries((await session.send("Performance.getMetrics")).metrics.map(({ name, value }) => [name, value]));
}

/** Moves as fast as a mouse reports them, whatever the page does. */
async function fast(page, title) {
  const at = await grab(page);
  await page.evaluate(() => window.probe.watch());
  const from = performance.now();
  const sent = [];
  for (let i = 0; i < STEPS; i++) {
    sent.push(page.mouse.move(...at(i / STEPS)));
    await new Promise((resolve) => setTimeout(resolve, Math.max(0, from + (i + 1) * PACE_MS - performance.now())));
  }
  await Promise.all(sent);
  const took = performance.now() - from;
  const { tasks, frames, results } = await page.evaluate(() => window.probe.watched());
  await page.mouse.up();
  const released = performance.now();
  await page.evaluate(() => document.querySelector("parkade-playground").settled());
  console.log(
    `\n${title}: ${STEPS} moves in ${took.toFixed(0)} ms, ${frames.length} frames, ` +
      `answers ${JSON.stringify(results)}, all settled ${(performance.now() - released).toFixed(0)} ms after release`,
  );
  row("between frames", frames);
  console.log(
    `main-thread tasks over 50 ` +
      `ms: ${tasks.length}${
        tasks.length > 0 ? `, longest ${Math.max(...tasks).toFixed(0)} ms` : ""
      }; target none: ${tasks.length === 0 ? "met" : "missed"}`,
  );
}

function row(name, values, target) {
  const at = (share) => quantile(values, share);
  const verdict = target === undefined ? "" : `; target ${target} ms at p95: ${at(0.95) <= target ? "met" : "missed"}`;
  console.log(
    `${name.padEnd(36)} p50 ${at(0.5).toFixed(1)}  p95 ${at(0.95).toFixed(1)}  max ${at(1).toFixed(1)} ms${verdict}`,
  );
}

async function open(page, preset) {
  await page.evaluate(async (id) => {
    const element = document.querySelector("parkade-playground");
    element.scene = id;
    await element.updateComplete;
    await element.settled();
  }, preset);
}

/** Presses on the goal and returns the way of the drag: a loop out of the bay into the aisle, along it and back. */
async function grab(page) {
  const { x, y, scale } = await page.evaluate(async () => {
    await window.probe.painted();
    return window.probe.goal();
  });
  await page.mouse.move(x, y);
  await page.mouse.down();
  const at = (share) => {
    const turn = 2 * Math.PI * share;
    return [x + 3 * scale * Math.sin(turn), y - 2.5 * scale * (1 - Math.cos(turn))];
  };
  // Away and back: the first few pixels of a press do not drag yet.
  await page.mouse.move(...at(0.1));
  await page.mouse.move(...at(0));
  await page.evaluate(() => document.querySelector("parkade-playground").settled());
  return at;
}

/** Runs in the page. */
async function installProbe() {
  await customElements.whenDefined("parkade-playground");
  const element = document.querySelector("parkade-playground");
  await element.ready;
  await element.settled();
  const { store } = element;
  const request = window.requestAnimationFrame.bind(window);
  let inFrame = false;
  window.requestAnimationFrame = (work) =>
    request((time) => {
      inFrame = true;
      try {
        work(time);
      } finally {
        inFrame = false;
      }
    });
  /** After the frame in which everything scheduled until now is painted: the one that is being made, or the next. */
  const painted = () =>
    new Promise((resolve) => {
      const afterFrame = () => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => resolve(performance.now());
        port2.postMessage(null);
      };
      if (inFrame) afterFrame();
      else request(afterFrame);
    });
  const isGrid = (planner) => !planner.startsWith("hybrid");
  let step = null;
  for (const type of ["pointerrawupdate", "pointermove"]) {
    addEventListener(
      type,
      (event) => {
        if (step) step.from ??= event.timeStamp;
      },
      { capture: true },
    );
  }
  store.subscribe((state) => {
    if (!step || step.from === undefined) return;
    const fresh = (planner) =>
      state.results[planner].status !== "planning" && state.results[planner].plan !== step.before[planner];
    for (const [name, ids] of [
      ["grid", state.planners.filter(isGrid)],
      ["hybrid", state.planners.filter((id) => !isGrid(id))],
    ]) {
      if (step.asked[name] || !ids.every(fresh)) continue;
      const mine = step;
      mine.asked[name] = true;
      void painted().then((now) => {
        mine.took[name] = now - mine.from;
        if (mine.took.grid !== undefined && mine.took.hybrid !== undefined) mine.resolve();
      });
    }
  });
  let watching = null;
  window.probe = {
    painted,
    goal() {
      const view = element.shadowRoot
        .querySelector("parkade-stage")
        .shadowRoot.querySelector("parkade-panel[active]")
        .shadowRoot.querySelector("parkade-scene-view");
      const box = view.getBoundingClientRect(),
        { camera, width, height } = view.view;
      const { x, y } = store.state.geometry.goal;
      return {
        x: box.left + width / 2 + (x - camera.x) * camera.scale,
        y: box.top + height / 2 - (y - camera.y) * camera.scale,
        scale: camera.scale,
      };
    },
    expect() {
      let resolve;
      const done = new Promise((end) => {
        resolve = end;
      });
      step = {
        before: Object.fromEntries(Object.entries(store.state.results).map(([id, { plan }]) => [id, plan])),
        asked: {},
        took: {},
        done,
        resolve,
      };
    },
    async drawn(patience) {
      let timer;
      await Promise.race([
        step.done,
        new Promise((resolve) => {
          timer = setTimeout(resolve, patience);
        }),
      ]);
      clearTimeout(timer);
      await element.settled();
      const { results } = store.state;
      return {
        grid: step.took.grid ?? patience,
        hybrid: step.took.hybrid ?? patience,
        found: results.hybrid.plan?.outcome === "found",
        path: [...(results.hybrid.plan?.path ?? [])],
        length: results.hybrid.plan?.metrics.length,
      };
    },
    watch() {
      const tasks = [],
        frames = [],
        results = {};
      const observer = new PerformanceObserver((list) =>
        tasks.push(...list.getEntries().map(({ duration }) => duration)),
      );
      observer.observe({ type: "longtask" });
      let last = performance.now(),
        frame = 0;
      const tick = (now) => {
        frames.push(now - last);
        last = now;
        frame = requestAnimationFrame(tick);
      };
      frame = requestAnimationFrame((now) => {
        last = now;
        frame = requestAnimationFrame(tick);
      });
      const stop = store.subscribe((state, previous) => {
        for (const id of state.planners)
          if (state.results[id]?.plan !== previous.results[id]?.plan) results[id] = (results[id] ?? 0) + 1;
      });
      watching = () => {
        tasks.push(...observer.takeRecords().map(({ duration }) => duration));
        observer.disconnect();
        cancelAnimationFrame(frame);
        stop();
        return { tasks, frames, results };
      };
    },
    watched: () => watching(),
  };
}
