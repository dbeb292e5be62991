import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import { complaintsOf, expectFourAnswers, onScreen, open, sceneOf, type PlaygroundElement } from "./playground.js";

const PHONE = { width: 390, height: 844 };

async function violations(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  return violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`);
}

for (const colorScheme of ["light", "dark"] as const) {
  test.describe(`in ${colorScheme} colours`, () => {
    test.use({ colorScheme, viewport: { width: 1400, height: 900 } });

    test("the page, the gallery and the keys satisfy axe", async ({ page }) => {
      await open(page);
      expect(await violations(page)).toEqual([]);
      await page.locator("parkade-toolbar .scene").click();
      await page.waitForTimeout(400);
      expect(await violations(page)).toEqual([]);
      await page.keyboard.press("Escape");
      await page.keyboard.press("?");
      await page.waitForTimeout(400);
      expect(await violations(page)).toEqual([]);
    });

    test("the phone's page satisfies axe", async ({ page }) => {
      await page.setViewportSize(PHONE);
      await open(page);
      expect(await violations(page)).toEqual([]);
    });
  });
}

test("a phone shows one map, nothing to scroll sideways, and the start pose in the open", async ({ page }) => {
  const complaints = complaintsOf(page);
  await page.setViewportSize(PHONE);
  await open(page);
  await expectFourAnswers(page);
  const { scroll, height } = await page.evaluate(() => {
    const stage = document.querySelector("parkade-playground")!.shadowRoot!.querySelector("parkade-stage")!;
    return { scroll: document.documentElement.scrollWidth, height: stage.getBoundingClientRect().height };
  });
  expect(scroll).toBeLessThanOrEqual(PHONE.width);
  expect(height).toBeGreaterThan(PHONE.height * 0.5);
  await expect(page.locator("parkade-scene-view")).toHaveCount(1);
  const { start } = await sceneOf(page);
  await page.evaluate(() => {
    // A fitted camera is not in the state; the drawing's own is.
    const stage = document.querySelector("parkade-playground")!.shadowRoot!.querySelector("parkade-stage")!.shadowRoot!;
    const view = stage.querySelector("parkade-scene-view") as unknown as { view: { camera: unknown } };
    document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ camera: view.view.camera });
  });
  const at = await onScreen(page, start.x, start.y);
  const top = await page.evaluate(
    ([x, y]) => {
      let root: Document | ShadowRoot = document,
        found: Element | null = null;
      for (;;) {
        const next: Element | null = root.elementFromPoint(x, y);
        if (!next || next === found) return found?.localName;
        found = next;
        if (!next.shadowRoot) return next.localName;
        root = next.shadowRoot;
      }
    },
    [at.x, at.y] as const,
  );
  expect(top).toBe("canvas");
  expect(complaints).toEqual([]);
});

test("controls of the phone are large enough for fingers", async ({ browser }) => {
  const page = await browser.newPage({ viewport: PHONE, hasTouch: true, isMobile: true });
  await open(page);
  const small = await page.evaluate(() => {
    const list: string[] = [];
    const visit = (root: ParentNode): void => {
      for (const element of root.querySelectorAll<HTMLElement>("*")) {
        if (element.shadowRoot) visit(element.shadowRoot);
        if (element.localName !== "button") continue;
        const { width, height } = element.getBoundingClientRect();
        if (width > 0 && (width < 40 || height < 24))
          list.push(`${element.ariaLabel ?? element.textContent?.trim()} ${width}×${height}`);
      }
    };
    visit(document);
    return list;
  });
  expect(small).toEqual([]);
  await page.close();
});

test("the language changes everywhere at once", async ({ page }) => {
  await page.setViewportSize({ width: 1400, height: 900 });
  await open(page);
  // Words end in their language's stops; a path with corners has no gear changes.
  const spoken = page.locator("parkade-notices output");
  await expect(spoken).toHaveText(/^4-neighbour: [^.]+.*\. [\d.]+ metres, [\d.]+ milliseconds\. 8-neighbour: /);
  await expect(spoken).toHaveText(/ Hybrid A\*: OK\. [\d.]+ metres, 1 gear change, [\d.]+ milliseconds\.$/);
  await page.locator("parkade-toolbar .lang").click();
  await expect(page.locator("parkade-playground")).toHaveAttribute("lang", "zh");
  await page.locator("parkade-table tbody button").first().click();
  await expect(page.locator("parkade-table thead th").first()).toHaveText("规划器");
  const english = await page.evaluate(() => {
    const left: string[] = [];
    const visit = (root: ParentNode): void => {
      for (const element of root.querySelectorAll("*")) {
        if (element.shadowRoot) visit(element.shadowRoot);
        const texts = [...element.childNodes]
          .filter((node) => node.nodeType === Node.TEXT_NODE)
          .map((node) => node.textContent!.trim());
        const names = ["aria-label", "title"].map((name) => element.getAttribute(name) ?? "");
        for (const text of [...texts, ...names])
          if (
            /[A-Za-z]{4,}/.test(text) &&
            !/\p{Script=Han}/u.test(text) &&
            !["STYLE", "SCRIPT"].includes(element.tagName)
          )
            left.push(text);
      }
    };
    visit(document.querySelector("parkade-playground")!.shadowRoot!);
    return [...new Set(left)].filter(
      (text) => !/^(Parkade|English|Ctrl|Markdown)/.test(text) && !/Parkade|Ctrl|Markdown|JSON|Shift/.test(text),
    );
  });
  expect(english).toEqual([]);
});

test.describe("with a finger", () => {
  test.use({ viewport: PHONE, hasTouch: true });

  test("a tap on a phone writes out force, slope and region of the cell", async ({ page }) => {
    await open(page);
    await page.waitForFunction(
      () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
    );
    await page.evaluate(() => {
      const playground = document.querySelector<PlaygroundElement>("parkade-playground")!;
      playground.scene = "random-60";
      playground.store.set({ focus: "risk-field" });
      return playground.settled();
    });
    const { x, y, width, height } = (await page.locator("parkade-scene-view").boundingBox())!;
    const readout = page.locator("parkade-stage .readout");
    await expect(readout).toHaveCount(0);
    // The first cells may be blocked.
    let at = 0.3;
    await expect(async () => {
      await page.touchscreen.tap(x + width * (at += 0.03), y + height * 0.45);
      await expect(readout).toContainText(/F[\d.]+.*k.*Table [12], region.*[1-8A-D]/, { timeout: 2000 });
    }).toPass();
    await page.evaluate(() =>
      document.querySelector<PlaygroundElement>("parkade-playground")!.store.set({ hover: null }),
    );
    await expect(readout).toHaveCount(0);
  });
});
