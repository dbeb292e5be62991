import { expect, test } from "@playwright/test";
import { complaintsOf, look, open, settled, type PlaygroundElement, type Untyped } from "./playground.js";
import { drag } from "./hands.js";

const hint = "parkade-hints div:not(.out)";

test("one sentence after another leads from the first drag to a wall and to a planner that fails", async ({ page }) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  const complaints = complaintsOf(page);
  await open(page);
  await expect(page.locator(hint)).toContainText("Drag me");
  // Another tool drags nothing, so the hint waits.
  const choose = (tool: string) =>
    page.evaluate((tool) => document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ tool }), tool);
  await choose("brush");
  await expect(page.locator(hint)).toHaveCount(0);
  await choose("select");
  await expect(page.locator(hint)).toContainText("Drag me");
  const { x, y } = await page.evaluate(
    () =>
      (document.querySelector<PlaygroundElement>("parkade-playground")!.store as Untyped).state.geometry.goal as {
        x: number;
        y: number;
      },
  );
  await look(page, x, y, 14);
  await drag(page, [
    [x, y],
    [x + 0.8, y + 0.4],
  ]);
  await settled(page);
  await expect(page.locator(hint)).toHaveText("Draw a wall and every planner replans.");
  // A hint goes with the next action, whichever it is.
  await page.keyboard.press("l");
  await expect(page.locator(hint)).toHaveCount(0);
  await page.keyboard.press("v");
  await expect(page.locator(hint)).toHaveText(/ fails\. The line on its map says why/);
  const row = page.locator("parkade-table tr[data-planner]", { has: page.locator("td.err") }).first();
  await row.click();
  await expect(page.locator(hint)).toHaveCount(0);
  // Seen once, each stays away.
  await page.reload();
  await settled(page);
  await page.waitForFunction(() => customElements.get("parkade-hints"));
  await expect(page.locator(hint)).toHaveCount(0);
  expect(complaints).toEqual([]);
});

test("a hint covers no control, no text and neither car at any size, and its button closes it", async ({ browser }) => {
  for (const [width, height] of [
    [320, 480],
    [390, 844],
    [844, 390],
    [1024, 768],
    [1400, 900],
    [1920, 1080],
  ] as const) {
    const page = await browser.newPage({ viewport: { width, height } });
    await open(page);
    await page.waitForFunction(() => customElements.get("parkade-hints"));
    const bubble = page.locator(hint);
    // The lowest page may have no room; then nothing is said.
    if (height === 480 && (await bubble.count()) === 0) continue;
    await expect(bubble).toContainText("Drag me");
    const covered = await bubble.evaluate((element) => {
      const box = element.getBoundingClientRect(),
        found: string[] = [];
      const walk = (root: ParentNode): void =>
        root.querySelectorAll("*").forEach((one) => {
          if (one.localName === "parkade-hints") return;
          if (one.shadowRoot) walk(one.shadowRoot);
          const text = [...one.childNodes]
            .filter((node) => node.nodeType === 3)
            .map((node) => node.textContent!.trim())
            .join("");
          if (
            (!text && !one.matches("button, input")) ||
            !one.checkVisibility({ visibilityProperty: true }) ||
            one.matches(".visually-hidden")
          )
            return;
          const { left, right, top, bottom } = one.getBoundingClientRect();
          if (left < box.right && right > box.left && top < box.bottom && bottom > box.top)
            found.push(`${one.localName} ${text}`);
        });
      walk(document.querySelector("parkade-playground")!.shadowRoot!);
      return found;
    });
    expect(covered, `${width}x${height}`).toEqual([]);
    // Its line begins at its edge and ends at the grip, however far that is.
    const apart = await page.locator("parkade-hints u").evaluate((line) => {
      const hints = (line.getRootNode() as ShadowRoot).host as HTMLElement & {
        bubble: { tip: [number, number]; to: [number, number] };
      };
      const { tip, to } = hints.bubble,
        { left, top, right, bottom } = line.getBoundingClientRect(),
        origin = hints.getBoundingClientRect();
      return Math.max(
        ...[tip, to].map(([x, y]) =>
          Math.max(left - origin.left - x, x - right + origin.left, top - origin.top - y, y - bottom + origin.top),
        ),
      );
    });
    expect(apart, `${width}x${height}`).toBeLessThanOrEqual(1);
    await bubble.getByRole("button", { name: "Close this hint" }).click();
    await expect(bubble).toHaveCount(0);
    await page.close();
  }
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test("a swipe over the map's title brings the next planner to the front", async ({ page }) => {
    await open(page);
    const title = page.locator("parkade-stage .title");
    const focus = () =>
      page.evaluate(
        () => (document.querySelector<PlaygroundElement>("parkade-playground")!.store.state as Untyped).focus as string,
      );
    expect(await focus()).toBe("hybrid");
    const box = (await title.boundingBox())!,
      middle = box.y + box.height / 2;
    const swipe = async (from: number, to: number): Promise<void> => {
      await page.mouse.move(box.x + from, middle);
      await page.mouse.down();
      await page.mouse.move(box.x + to, middle, { steps: 4 });
      await page.mouse.up();
    };
    await swipe(100, 40);
    expect(await focus()).toBe("four");
    await swipe(40, 100);
    expect(await focus()).toBe("hybrid");
    await swipe(40, 50);
    expect(await focus()).toBe("hybrid");
  });
});
