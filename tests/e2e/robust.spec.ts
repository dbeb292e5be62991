import { AxeBuilder } from "@axe-core/playwright";
import { expect, test, type Page } from "@playwright/test";
import {
  expectFourAnswers,
  hashesOf,
  open,
  sceneOf,
  settled,
  type PlaygroundElement,
  type Untyped,
} from "./playground.js";

test.use({ viewport: { width: 1400, height: 900 } });

/** What the tests reach behind the element. */
interface Inside extends PlaygroundElement {
  app: { openScene(scene: unknown): void; store: PlaygroundElement["store"] };
}

test("500 mutated links and files never break the page", async ({ page }) => {
  test.setTimeout(240_000);
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await open(page);
  await page.waitForFunction(
    () => document.querySelector<PlaygroundElement>("parkade-playground")!.store.state.complete,
  );
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = {
      ...element.sceneData,
      costs: [
        {
          id: "cost-1",
          runs: [
            [20, 20, 9],
            [20, 21, 9],
          ],
          weight: 4,
        },
      ],
    };
  });
  await settled(page);
  const before = await sceneOf(page),
    hashes = await hashesOf(page);
  const link = new URL(
    (await page.evaluate(() => document.querySelector<PlaygroundElement>("parkade-playground")!.shareURL()))!,
  ).hash;
  const tally = await page.evaluate(
    async ([hash, text]) => {
      const element = document.querySelector<Inside>("parkade-playground")!;
      let seed = 11;
      const random = (below: number): number => {
        seed = (seed * 48271) % 2147483647;
        return seed % below;
      };
      const mutated = (whole: string, letters: string): string => {
        let out = whole;
        for (let n = 1 + random(3); n > 0; n--) {
          const at = random(out.length),
            letter = letters[random(letters.length)]!;
          const kind = random(3);
          out =
            kind === 0
              ? out.slice(0, at) + letter + out.slice(at + 1)
              : kind === 1
                ? out.slice(0, at) + out.slice(at + 1 + random(12))
                : out.slice(0, at) + letter + out.slice(at);
        }
        return out;
      };
      const pause = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));
      const tally = { refused: 0, taken: 0 };
      const count = (): void => {
        if (element.store.state.message?.tone === "err") tally.refused++;
        else tally.taken++;
        element.store.set({ message: null });
      };
      const abc = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_%";
      for (let i = 0; i < 250; i++) {
        location.hash = `${hash.slice(0, 4)}${mutated(hash.slice(4), abc)}`;
        await pause(12);
        count();
      }
      const bar = element.shadowRoot!.querySelector("parkade-import") as unknown as {
        openFiles(files: File[]): Promise<void>;
      } & Element;
      element.shadowRoot!.querySelector("input")!.dispatchEvent(new Event("none"));
      for (let i = 0; i < 250; i++) {
        await bar.openFiles([new File([mutated(text, '0123456789.-{}[]",:eE ')], "mutated.json")]);
        count();
      }
      return tally;
    },
    await (async () => {
      // The bar that opens files comes with the first one.
      await page.locator("parkade-playground input[type=file]").setInputFiles({
        name: "same.json",
        mimeType: "application/json",
        buffer: Buffer.from(JSON.stringify(before)),
      });
      await expect(page.locator("parkade-notices .notice.info")).toContainText("Opened");
      return [link, JSON.stringify(before)] as [string, string];
    })(),
  );
  expect(tally.refused + tally.taken).toBe(500);
  expect(tally.refused).toBeGreaterThan(100);
  await page.evaluate((scene) => {
    document.querySelector<PlaygroundElement>("parkade-playground")!.sceneData = scene;
  }, before);
  await settled(page);
  await expectFourAnswers(page);
  expect(await hashesOf(page)).toEqual(hashes);
  expect(errors).toEqual([]);
});

test("a planner's worker that dies is said and started again; scene, plans and history stay", async ({ page }) => {
  await open(page);
  await page.evaluate(() => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.sceneData = { ...element.sceneData, start: { ...element.sceneData.start, x: 19 } };
  });
  await settled(page);
  const scene = await sceneOf(page),
    hashes = await hashesOf(page);
  await page.evaluate(async () => {
    const { app } = document.querySelector("parkade-playground") as unknown as {
      app: { planning: { lanes: Map<string, { worker: Worker }> } };
    };
    const { worker } = [...app.planning.lanes.values()][0]!;
    worker.dispatchEvent(new ErrorEvent("error", { message: "out of memory", cancelable: true }));
  });
  await expect(page.locator("parkade-notices .notice.warn")).toContainText("crashed and was restarted");
  expect(await sceneOf(page)).toEqual(scene);
  await page.keyboard.press("Control+z");
  await settled(page);
  await page.keyboard.press("Control+Shift+z");
  await settled(page);
  expect(await hashesOf(page)).toEqual(hashes);
});

test("a spent budget is said in words, and the last path stays in sight", async ({ page }) => {
  await open(page);
  await page.evaluate(async () => {
    const element = document.querySelector<PlaygroundElement>("parkade-playground")!;
    element.scene = "par-7.2";
    await element.updateComplete;
    await element.settled();
    // An edit: a scene that is opened anew keeps no path of the one before.
    (element as Untyped).store.edit(
      { ...element.sceneData, planners: { hybrid: { maxExpansions: 5 } } },
      { label: "params" },
    );
  });
  await settled(page);
  expect(
    await page.evaluate(
      () => document.querySelector<PlaygroundElement>("parkade-playground")!.results["hybrid"]!.outcome,
    ),
  ).toBe("budget-spent");
  const panel = page.locator("parkade-panel[active]");
  await expect(panel.locator(".chip").first()).toContainText("ran out of budget");
  await expect(panel.locator("parkade-failure p")).not.toBeEmpty();
  const last = await page.evaluate(() => {
    const { results } = document.querySelector<PlaygroundElement>("parkade-playground")!.store.state as unknown as {
      results: Record<string, { lastGood: { outcome: string } | null }>;
    };
    return results["hybrid"]!.lastGood?.outcome;
  });
  expect(last).toBe("found");
});

const violations = async (page: Page): Promise<string[]> => {
  const { violations } = await new AxeBuilder({ page })
    .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"])
    .analyze();
  return violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join("; ")}`);
};

for (const mode of ["grid", "overlay", "focus"]) {
  test(`axe finds nothing in the arrangement ${mode}, with a group chosen and a tool in hand`, async ({ page }) => {
    await open(page);
    await page.evaluate((wanted) => {
      const { store } = document.querySelector<PlaygroundElement>("parkade-playground")!;
      store.set({ mode: wanted });
    }, mode);
    await page.keyboard.press("Control+a");
    await page.waitForTimeout(300);
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press("p");
    await page.waitForTimeout(200);
    expect(await violations(page)).toEqual([]);
  });
}

test("axe finds nothing in the menus, the picture's dialog and the planners' cases", async ({ page }) => {
  await open(page);
  await page.getByRole("button", { name: "Export" }).click();
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press("Escape");
  const png = await page.evaluate(() => document.createElement("canvas").toDataURL("image/png").split(",")[1]!);
  await page
    .locator("parkade-playground input[type=file]")
    .setInputFiles({ name: "empty.png", mimeType: "image/png", buffer: Buffer.from(png, "base64") });
  await expect(page.locator("parkade-image dialog")).toBeVisible();
  await page.waitForTimeout(300);
  expect(await violations(page)).toEqual([]);
  await page.keyboard.press("Escape");
  await page.locator("parkade-toolbar .scene").click();
  await page.getByRole("button", { name: "Best and worst" }).click();
  await page.waitForTimeout(500);
  expect(await violations(page)).toEqual([]);
});
