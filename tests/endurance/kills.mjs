// Kills planners' workers in the midst of their plans and asks whether the page recovers: `cargo xtask endurance kills
// [count] [seed]`.
import { quantile } from "../quantile.mjs";
import { withPage } from "./page.mjs";
import { random } from "./random.mjs";

const count = Number(process.argv[2] ?? 1000),
  seed = Number(process.argv[3] ?? 1);
const next = random(seed);
/** A recovery that takes longer is none. */
const PATIENCE_MS = 10_000;

const quiet = await withPage(async (page, version) => {
  console.log(`Chromium ${version}, ${count} kills, seed ${seed}`);
  const before = await page.evaluate(() => stateOfPage());
  const times = [],
    lost = [];
  const perPlanner = {};
  for (let i = 0; i < count; i++) {
    const outcome = await page.evaluate(
      ([edit, victim, delay, patience]) => killOnce(edit, victim, delay, patience),
      [next(1000), next(4), next(2) * next(12), PATIENCE_MS],
    );
    perPlanner[outcome.planner] = (perPlanner[outcome.planner] ?? 0) + 1;
    if (!outcome.recovered) lost.push({ kill: i, ...outcome });
    else if (outcome.atWork) times.push(outcome.millis);
    if ((i + 1) % 100 === 0) console.log(`${i + 1} kills, ${i + 1 - lost.length} recoveries`);
  }
  const undone = await page.evaluate(() => stateOfPage());
  const after = await page.evaluate((scene) => stateOfPage(scene), before.scene);
  console.log(`killed: ${JSON.stringify(perPlanner)}`);
  console.log(
    `${count} kills, ${count - lost.length} recoveries; ${times.length} of the workers were at work: to the plans ` +
      `of all p50 ${quantile(times, 0.5).toFixed(1)}, p95 ${quantile(times, 0.95).toFixed(
        1,
      )}, max ${quantile(times, 1).toFixed(1)} ms`,
  );
  const same = undone.kept && after.hashes === before.hashes && after.scene === before.scene;
  console.log(
    `${undone.steps} steps undone: ${undone.kept ? "the scene of then" : "ANOTHER SCENE"}; plans of the first ` +
      `scene: ${after.hashes === before.hashes ? "as before" : "DIFFERENT"}`,
  );
  for (const one of lost.slice(0, 5)) console.log("not recovered:", JSON.stringify(one));
  if (lost.length > 0 || !same) process.exitCode = 1;
}, prepare);
if (!quiet) process.exitCode = 1;

/** Runs in the page before anything else. */
function prepare() {
  const element = () => document.querySelector("parkade-playground");
  const scenes = [];
  /** Undoes all that is kept, then shows the scene, if one is given. */
  window.stateOfPage = async (shown) => {
    let steps = 0;
    for (; element().store.state.canUndo; steps++) element().store.undo();
    const kept = steps === 0 || JSON.stringify(element().sceneData) === scenes.at(-steps);
    if (shown !== undefined) element().sceneData = JSON.parse(shown);
    await element().settled();
    return {
      steps,
      kept,
      scene: JSON.stringify(element().sceneData),
      hashes: JSON.stringify(Object.entries(element().results).map(([id, plan]) => [id, plan?.hash])),
    };
  };
  /** Moves the goal, and kills one planner's worker a little later, at work or not. */
  window.killOnce = async (edit, victim, delay, patience) => {
    const { store, app } = element(),
      { scene } = store.state;
    const planner = store.state.planners[victim % store.state.planners.length];
    const goal = { x: 6 + (edit % 20) * 0.5, y: 8 + (edit % 7) * 0.25, heading: 0 };
    scenes.push(JSON.stringify(scene));
    store.edit({ ...scene, goal });
    const undo = store.state.canUndo;
    const from = performance.now();
    if (delay > 0) await new Promise((done) => setTimeout(done, delay));
    const lane = app.planning.lanes.get(planner),
      worker = lane?.worker,
      atWork = lane?.busy;
    if (!worker) return { planner, recovered: false, why: "no worker" };
    worker.terminate();
    const killed = performance.now();
    worker.dispatchEvent(new ErrorEvent("error", { message: "killed", cancelable: true }));
    const settled = await Promise.race([
      element()
        .settled()
        .then(() => true),
      new Promise((done) => setTimeout(() => done(false), patience)),
    ]);
    const millis = performance.now() - killed;
    const state = element().store.state,
      result = state.results[planner];
    const kept = state.scene.goal.x === goal.x && state.canUndo === undo;
    const recovered =
      settled &&
      kept &&
      result.status === "done" &&
      Object.values(state.results).every(({ status }) => status === "done");
    return {
      planner,
      recovered,
      atWork,
      millis,
      late: killed - from,
      settled,
      kept,
      status: result.status,
      error: result.error,
    };
  };
}
