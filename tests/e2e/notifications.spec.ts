import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, look, onScreen, open, settled, type PlaygroundElement } from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

/** Of one frame: its milliseconds, the notifications of the store, and the planners whose answers they brought. */
interface Frame {
  time: number;
  told: number;
  answers: number;
}

/** Counts from now on, frame by frame, until `stop` is called in the page. */
function count(page: Page): Promise<void> {
  return page.evaluate(() => {
    const { store } = document.querySelector<PlaygroundElement>("parkade-playground")!,
      frames: Frame[] = [];
    let frame: Frame = { time: 0, told: 0, answers: 0 },
      since = performance.now(),
      before = store.state.results;
    const stop = store.subscribe(() => {
      const { planners, results } = store.state;
      frame.told++;
      frame.answers += planners.filter((one) => results[one]?.plan !== before[one]?.plan).length;
      before = results;
    });
    // Observers of sizes are called last in a frame, before it is painted.
    const box = document.body.appendChild(document.createElement("div"));
    let next = 0;
    const observer = new ResizeObserver(() => {
      const now = performance.now();
      frames.push({ ...frame, time: now - since });
      [frame, since] = [{ time: 0, told: 0, answers: 0 }, now];
    });
    box.style.position = "fixed";
    observer.observe(box);
    const tick = (): void => {
      box.style.width = box.style.width === "1px" ? "2px" : "1px";
      next = requestAnimationFrame(tick);
    };
    tick();
    Object.assign(window, {
      stop: () => {
        stop();
        observer.disconnect();
        cancelAnimationFrame(next);
        return frames;
      },
    });
  });
}

test("a frame brings at most one notification while a wall is drawn before four planners", async ({ page }) => {
  const complaints = complaintsOf(page);
  await open(page);
  await settled(page);
  await look(page, 10, 7, 18);
  await page.keyboard.press("b");
  const [from, to] = [await onScreen(page, 6, 4), await onScreen(page, 14, 4)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await count(page);
  const steps = 80;
  for (let step = 1; step <= steps; step++)
    await page.mouse.move(from.x + ((to.x - from.x) * step) / steps, from.y + ((to.y - from.y) * step) / steps);
  const frames = await page.evaluate(() => (window as unknown as { stop(): Frame[] }).stop());
  await page.mouse.up();
  await settled(page);
  // In longer ones changes are told without a frame.
  const short = frames.filter(({ time }) => time < 90),
    sum = (key: "told" | "answers"): number => short.reduce((all, frame) => all + frame[key], 0);
  console.log(
    `${short.length} of ${frames.length} frames: ${sum("told")} notifications, at ` +
      `most ${Math.max(...short.map(({ told }) => told))} in one; ${sum("answers")} answers`,
  );
  expect(sum("answers")).toBeGreaterThan(20);
  expect(Math.max(...short.map(({ told }) => told))).toBe(1);
  expect(complaints).toEqual([]);
});
