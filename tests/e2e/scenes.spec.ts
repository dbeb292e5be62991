import { expect, test, type Page } from "@playwright/test";
import type { Plan, Scenario } from "parkade";
import { answered, open, settled, type PlaygroundElement } from "./playground";

interface Shown {
  plan: Plan | null;
  lastGood: Plan | null;
  drive: { duration: number } | null;
  status: string;
  error: unknown;
  millis: number | null;
}
interface Inside extends PlaygroundElement {
  app: {
    openPreset(id: string): void;
    openScene(scene: Scenario): void;
    complete(): Promise<unknown>;
    catalog: { scenarios: { id: string }[]; planners: { id: string }[] };
  };
  store: PlaygroundElement["store"] & {
    state: { results: Record<string, Shown>; playback: { playing: boolean } };
    undo(): void;
    redo(): void;
    edit(scene: Scenario, options?: object): void;
  };
}

/** Plans that stand anywhere in the results at the moment that the scene changes, with nothing answered yet. */
const rightAfter = (page: Page, how: string) =>
  page.evaluate(async (way) => {
    const element = document.querySelector<Inside>("parkade-playground")!;
    const { store, app } = element;
    const elsewhere = { ...store.state.scene, start: { ...store.state.scene.start, x: store.state.scene.start.x + 1 } };
    if (way === "openScene") app.openScene(elsewhere);
    else if (way === "sceneData") element.sceneData = elsewhere;
    else if (way === "undo") store.undo();
    else if (way === "redo") store.redo();
    else if (way === "link") location.hash = (await element.shareURL())!.split("#")[1]!.replace(/&v=.*/, "");
    else if (way === "edit") store.edit(elsewhere);
    await element.updateComplete;
    const { results } = store.state;
    return Object.values(results)
      .flatMap(({ plan, lastGood, drive }) => [plan, lastGood, drive])
      .filter(Boolean).length;
  }, how);

test("another scene shows no plan of the one before, however it is opened", async ({ page }) => {
  await open(page);
  await settled(page);
  expect(await rightAfter(page, "edit")).toBeGreaterThan(0);
  for (const way of ["openScene", "undo", "redo", "sceneData"]) {
    await settled(page);
    expect(await rightAfter(page, way), way).toBe(0);
  }
  await settled(page);
});

test("every preset with its planners and a third of the others: no error, and a drive in plausible time", async ({
  page,
}) => {
  test.setTimeout(600_000);
  await open(page);
  const ids = await page.evaluate(async () => {
    const { app } = document.querySelector<Inside>("parkade-playground")!;
    await app.complete();
    return app.catalog.scenarios.map(({ id }) => id);
  });
  const faults: string[] = [];
  let pairs = 0,
    drives = 0;
  for (const [at, id] of ids.entries()) {
    await page.evaluate(
      ([one, at]) => {
        const { app, store } = document.querySelector<Inside>("parkade-playground")!;
        const planners = app.catalog.planners.map(({ id }) => id);
        store.set({ message: null });
        app.openPreset(one);
        // What it features, and a third of the others, each time another one: `parity.spec.ts` has all of all.
        const featured = store.state.planners;
        store.set({ planners: planners.filter((one, i) => featured.includes(one) || i % 3 === at % 3) });
      },
      [id, at] as const,
    );
    await answered(page);
    const said = await page.evaluate((id) => {
      const { results, message, scene } = document.querySelector<Inside>("parkade-playground")!.store.state;
      const faults = message ? [`${id}: ${message.text}`] : [];
      let drives = 0;
      for (const [planner, { plan, drive, status, error }] of Object.entries(results)) {
        const name = `${id} ${planner}`;
        if (status !== "done" || !plan) faults.push(`${name}: ${status} ${JSON.stringify(error)}`);
        else if (plan.outcome === "found" && plan.check.drivable && !scene.moving?.length) {
          drives++;
          const { length, directionChanges } = plan.metrics;
          const least = length / 10,
            most = 20 + 2 * length + 10 * directionChanges;
          if (!drive || !(drive.duration >= least && drive.duration <= most))
            faults.push(`${name}: ${length} m in ${drive?.duration} s`);
        }
      }
      return { faults, drives, pairs: Object.keys(results).length };
    }, id);
    faults.push(...said.faults);
    pairs += said.pairs;
    drives += said.drives;
  }
  expect(faults).toEqual([]);
  expect(pairs).toBeGreaterThanOrEqual(300);
  expect(drives).toBeGreaterThan(50);
});
