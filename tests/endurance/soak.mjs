// Random edits for hours: `cargo xtask endurance soak [minutes] [seed]`. Memory must stay flat after the first ten
// minutes.
import { quantile } from "../quantile.mjs";
import { withPage } from "./page.mjs";
import { random } from "./random.mjs";

const minutes = Number(process.argv[2] ?? 120),
  seed = Number(process.argv[3] ?? 1);
const next = random(seed);
const PER_SECOND = 30,
  GROWTH = 1.05;
const warm = Math.min(10, minutes / 4);

const quiet = await withPage(
  async (page, version) => {
    console.log(`Chromium ${version}, ${minutes} minutes of ${PER_SECOND} edits a second, seed ${seed}`);
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable");
    await session.send("HeapProfiler.enable");
    const from = performance.now();
    const samples = [];
    let edits = 0,
      before = 0;
    const elapsed = () => (performance.now() - from) / 60_000;
    for (let second = 0; elapsed() < minutes; second++) {
      await new Promise((done) => setTimeout(done, from + second * 1000 - performance.now()));
      const orders = Array.from({ length: PER_SECOND }, () => [next(100), next(1 << 30), next(1 << 30)]);
      await page.evaluate(([orders, pause]) => editMany(orders, pause), [orders, 1000 / PER_SECOND]);
      edits += orders.length;
      if (second % 60 === 59 || elapsed() >= minutes) {
        const rate = (edits - before) / 60 / (elapsed() - (samples.at(-1)?.minute ?? 0));
        before = edits;
        const latencies = await page.evaluate(() => took.splice(0));
        const memory = await measure(page, session);
        samples.push({ minute: elapsed(), p50: quantile(latencies, 0.5), p95: quantile(latencies, 0.95), ...memory });
        const { minute, heap, wasm, nodes, p50, p95 } = samples.at(-1);
        console.log(
          `minute ${minute.toFixed(1)}: ${edits} edits, ${rate.toFixed(1)} a second, ` +
            `heap ${heap.toFixed(1)} MB, wasm ${wasm.toFixed(1)} MB in ${memory.workers} workers, ` +
            `${nodes} nodes, edit to settled p50 ${p50.toFixed(0)}, p95 ${p95.toFixed(0)} ms`,
        );
      }
    }
    const calm = samples.filter(({ minute }) => minute >= warm),
      half = Math.ceil(calm.length / 2);
    // A module gives its memory back only with its worker: what the hardest of the last plans took comes and goes, and
    // a leak lifts the floor.
    for (const [name, unit, part, judged] of [
      ["heap", "MB", 0.5, true],
      ["wasm", "MB", 0.1, true],
      ["nodes", "", 0.5, true],
      ["p95", "ms", 0.5, false],
    ]) {
      const level = (some) =>
        quantile(
          some.map((one) => one[name]),
          part,
        );
      const early = level(calm.slice(0, half)),
        late = level(calm.slice(half));
      const flat = late <= early * GROWTH;
      const most = Math.max(...calm.map((one) => one[name])).toFixed(1);
      console.log(
        `${name}: ${part === 0.5 ? "median" : "lowest tenth"} ${early.toFixed(1)} ${unit} in the first half after ` +
          `minute ${warm}, ${late.toFixed(1)} ${unit} in the second, ` +
          `${most} ${unit} at most: ${flat ? "flat" : "GROWN"}`,
      );
      // Times depend on what else the machine does.
      if (judged && !flat) process.exitCode = 1;
    }
    // Where no graphics processor draws, larger pictures leave no time for thirty edits a second.
  },
  prepare,
  { width: 640, height: 480 },
);
if (!quiet) process.exitCode = 1;

/** After a collection: the page's heap, and the modules' memories in its workers and itself. */
async function measure(page, session) {
  await page.evaluate(() => document.querySelector("parkade-playground").settled());
  await session.send("HeapProfiler.collectGarbage");
  const { metrics } = await session.send("Performance.getMetrics");
  const of = (name) => metrics.find((one) => one.name === name).value;
  const bytes = await Promise.all(
    page
      .workers()
      .map((worker) =>
        worker
          .evaluate(() => globalThis.memories?.reduce((sum, memory) => sum + memory.buffer.byteLength, 0) ?? 0)
          .catch(() => 0),
      ),
  );
  return {
    heap: of("JSHeapUsedSize") / 1e6,
    nodes: of("Nodes"),
    wasm: bytes.reduce((a, b) => a + b, 0) / 1e6,
    workers: bytes.length,
  };
}

/** Runs in the page before anything else. */
function prepare() {
  window.took = [];
  window.editMany = async (orders, pause) => {
    const element = document.querySelector("parkade-playground");
    let due = performance.now();
    for (const [kind, a, b] of orders) {
      const { store } = element,
        { scene } = store.state;
      const x = 1 + (a % 3000) / 100,
        y = 1 + (b % 2000) / 100,
        heading = ((a % 628) - 314) / 100;
      const from = performance.now();
      const obstacles = scene.obstacles ?? [];
      if (kind < 30) store.edit({ ...scene, goal: { x, y, heading } });
      else if (kind < 45) store.edit({ ...scene, start: { x, y, heading } });
      else if (kind < 65)
        store.edit({
          ...scene,
          obstacles: [
            ...obstacles,
            {
              type: "rectangle",
              id: `s${a}-${b}`,
              center: [x, y],
              size: [0.5 + (a % 20) / 10, 0.5 + (b % 20) / 10],
              heading,
            },
          ],
        });
      else if (kind < 85 && obstacles.length > 4)
        store.edit({ ...scene, obstacles: obstacles.toSpliced(a % obstacles.length, 1) });
      else if (kind < 93) store.undo();
      else store.redo();
      if (obstacles.length > 24) store.edit({ ...scene, obstacles: obstacles.slice(0, 8) });
      element.settled().then(() => took.push(performance.now() - from));
      due += pause;
      await new Promise((done) => setTimeout(done, due - performance.now()));
    }
  };
}
