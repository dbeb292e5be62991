import { expect, test } from "@playwright/test";
import { type Embed, ready, visit } from "./styled-host";

test("attributes are properties, and do what they say before and after the playground is there", async ({ page }) => {
  await visit(
    page,
    'layout="single" controls="minimal" autoplay speed="0.01" layers="clean" wheel="always" editable',
    "",
  );
  await ready(page);
  const read = () =>
    page.evaluate(() => {
      const element = document.querySelector("parkade-playground") as Embed & Record<string, unknown>;
      return {
        layout: element["layout"],
        autoplay: element["autoplay"],
        speed: element["speed"],
        wheel: element["wheel"],
        budgetMs: element["budgetMs"],
        camera: element["camera"],
        playhead: element["playhead"] as number,
      };
    });
  expect(await read()).toMatchObject({
    layout: "single",
    autoplay: true,
    speed: "0.01",
    wheel: "always",
    budgetMs: null,
    camera: null,
  });
  // It drives in, slowly.
  await expect.poll(async () => (await read()).playhead).toBeLessThan(0.5);
  await expect.poll(async () => (await read()).playhead).toBeGreaterThan(0);
  const canvas = page.locator("parkade-playground canvas").first();
  const wheel = async () => {
    await canvas.hover();
    await page.mouse.wheel(0, -60);
  };
  await wheel();
  await expect.poll(async () => (await read()).camera).not.toBeNull();
  await page.evaluate(() => Object.assign(document.querySelector("parkade-playground")!, { wheel: "none" }));
  const { camera } = await read();
  await page.keyboard.down("Control");
  await wheel();
  await page.keyboard.up("Control");
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  expect((await read()).camera).toEqual(camera);
  // A scene's address, a link, another scene: each in its turn; selecting is told.
  await page.route("**/host/own.json", (route) =>
    route.fulfill({
      json: {
        version: 1,
        name: "Own",
        map: { origin: [0, 0], width: 40, height: 30, resolution: 0.5 },
        start: { x: 3, y: 7, heading: 0 },
        goal: { x: 15, y: 7, heading: 0 },
      },
    }),
  );
  const names = await page.evaluate(async () => {
    const element = document.querySelector("parkade-playground") as Embed & {
      getScene(): Promise<{ name?: string }>;
      openLink(link: string): Promise<void>;
      shareURL(): Promise<string>;
      src: string;
      scene: string;
    };
    const name = async () => (await element.getScene()).name;
    const changed = () => new Promise((done) => element.addEventListener("scene-change", done, { once: true }));
    const seen: (string | undefined)[] = [await name()];
    let next = changed();
    element.src = "own.json";
    await next;
    seen.push(await name());
    const link = await element.shareURL();
    next = changed();
    element.scene = "parallel";
    await next;
    seen.push(await name());
    await element.openLink(link);
    seen.push(await name());
    return seen;
  });
  expect(names).toEqual(["perpendicular", "Own", "parallel", "Own"]);
  const selected = page.evaluate(
    () =>
      new Promise((done) =>
        document.querySelector("parkade-playground")!.addEventListener("select", (event) => {
          if (event instanceof CustomEvent) done(event.detail);
        }),
      ),
  );
  await page.evaluate(() => (document.querySelector("parkade-playground") as Embed & { fit(): Promise<void> }).fit());
  const box = (await canvas.boundingBox())!;
  // The whole lot of 20 × 15 m is fitted; the start car's middle is 5.6 m left of its own.
  const scale = (0.88 * (box.height - 28)) / 15;
  await page.mouse.click(box.x + box.width / 2 - 5.6 * scale, box.y + (box.height + 28) / 2 + 0.5 * scale);
  expect(await selected).toEqual({ selection: { kind: "start" } });
});
