import { expect, test, type Page } from "@playwright/test";
import type { Plan, PlannerId } from "parkade";
// What the package's users have, not what the page's build makes of it.
import { init, Planner, scenario, toSVG } from "../../pkg/node.js";

interface Embed extends HTMLElement {
  ready: Promise<void>;
  dismissPoster(): Promise<void>;
  toSVG(): Promise<string>;
}
interface Case {
  name: string;
  width: number;
  height: number;
  attributes: string;
  scheme: "light" | "dark";
  make: (page: Page) => Promise<string>;
}

/**
 * Colours of one pixel may differ by this much of 255 in each part: text and edges are smoothed in other ways in files.
 */
const TOLERANCE = 24;
/** Of the map's pixels. */
const MOST_DIFFERENT = 0.003;

type Sized = { width: number; height: number };
const plans = (scene: string, planners: readonly PlannerId[]): Plan[] =>
  planners.map((planner) => {
    const prepared = new Planner(planner, scenario(scene)),
      plan = prepared.plan({ trace: true });
    prepared.free();
    return plan;
  });

const CASES: Case[] = [
  {
    name: "one planner, no controls",
    width: 720,
    height: 420,
    attributes: 'layout="single" controls="none"',
    scheme: "light",
    make: made("perpendicular", ["hybrid"], { layout: "single", controls: "none", width: 720, height: 420 }),
  },
  {
    name: "one planner, few controls, dark",
    width: 800,
    height: 467,
    attributes: 'scene="parallel" layout="single" controls="minimal"',
    scheme: "dark",
    make: made("parallel", ["hybrid"], { layout: "single", controls: "minimal", width: 800, height: 467 }),
  },
  {
    name: "a grid planner with its search",
    width: 720,
    height: 420,
    attributes: 'planners="eight" layout="single" controls="none" theme="dark"',
    scheme: "light",
    make: made("perpendicular", ["eight"], {
      layout: "single",
      controls: "none",
      theme: "dark",
      width: 720,
      height: 420,
    }),
  },
  {
    name: "several planners, one over another",
    width: 720,
    height: 420,
    attributes: 'planners="four eight hybrid" layout="overlay" controls="minimal"',
    scheme: "light",
    make: made("perpendicular", ["four", "eight", "hybrid"], {
      layout: "overlay",
      controls: "minimal",
      width: 720,
      height: 420,
    }),
  },
  {
    name: "a phone",
    width: 358,
    height: 320,
    attributes: 'layout="single" controls="minimal"',
    scheme: "dark",
    make: made("perpendicular", ["hybrid"], { layout: "single", controls: "minimal", width: 358, height: 320 }),
  },
  {
    name: "by itself, beside each other with every control",
    width: 900,
    height: 520,
    attributes: 'planners="four risk-field eight hybrid" layout="grid" controls="full"',
    scheme: "light",
    make: ownPicture,
  },
  {
    name: "by itself, on a phone",
    width: 358,
    height: 480,
    attributes: 'planners="eight hybrid" controls="full"',
    scheme: "light",
    make: ownPicture,
  },
];

function made(
  scene: string,
  planners: readonly PlannerId[],
  options: NonNullable<Parameters<typeof toSVG>[2]> & Sized,
): () => Promise<string> {
  return async () => toSVG(scenario(scene), plans(scene, planners), options);
}

/** As authors make it of a playground with many maps. */
function ownPicture(page: Page): Promise<string> {
  return page.evaluate(async () => {
    const element = document.querySelector("parkade-playground") as Embed;
    await element.dismissPoster();
    return element.toSVG();
  });
}

const CHROME =
  ".legend, .title, .corner, .edit, parkade-failure, .readout, .weights, .scale, parkade-hints, parkade-view-controls";

/** Where the maps are, and what lies over them. */
const places = (page: Page) =>
  page.evaluate((selector) => {
    const maps: DOMRect[] = [],
      over: DOMRect[] = [];
    const look = (root: ParentNode): void => {
      for (const element of root.querySelectorAll("*")) {
        if (element.matches("parkade-scene-view")) maps.push(element.getBoundingClientRect());
        else if (element.matches(selector)) over.push(element.getBoundingClientRect());
        if (element.shadowRoot) look(element.shadowRoot);
      }
    };
    look(document);
    return JSON.parse(JSON.stringify({ maps, over })) as { maps: DOMRect[]; over: DOMRect[] };
  }, CHROME);

/** The share of the maps' pixels that differ. */
const difference = (page: Page, pictures: readonly Buffer[], { maps, over }: Awaited<ReturnType<typeof places>>) =>
  page.evaluate(
    async ({ texts, tolerance, maps: shown, over: hidden }) => {
      const [a, b] = await Promise.all(
        texts.map(async (text) => {
          const bitmap = await createImageBitmap(
            new Blob([Uint8Array.from(atob(text), (one) => one.charCodeAt(0))], { type: "image/png" }),
          );
          const canvas = document.createElement("canvas");
          canvas.width = bitmap.width;
          canvas.height = bitmap.height;
          const pen = canvas.getContext("2d")!;
          pen.drawImage(bitmap, 0, 0);
          return pen.getImageData(0, 0, bitmap.width, bitmap.height);
        }),
      );
      const inside = (x: number, y: number, boxes: readonly DOMRect[]) =>
        boxes.some((box) => x >= box.left && x < box.right && y >= box.top && y < box.bottom);
      let looked = 0,
        different = 0;
      for (let y = 0; y < a!.height; y++) {
        for (let x = 0; x < a!.width; x++) {
          if (!inside(x, y, shown) || inside(x, y, hidden)) continue;
          looked++;
          const at = 4 * (y * a!.width + x);
          if ([0, 1, 2].some((part) => Math.abs(a!.data[at + part]! - b!.data[at + part]!) > tolerance)) different++;
        }
      }
      return { looked, share: different / looked };
    },
    { texts: pictures.map((picture) => picture.toString("base64")), tolerance: TOLERANCE, maps, over },
  );

test.beforeAll(() => init());

for (const { name, width, height, attributes, scheme, make } of CASES) {
  test(`a poster is the first frame: ${name}`, async ({ page }, info) => {
    await page.emulateMedia({ reducedMotion: "reduce", colorScheme: scheme });
    await page.setViewportSize({ width: width + 20, height: height + 20 });
    let poster = "";
    await page.route("**/host/poster.svg", (route) => route.fulfill({ contentType: "image/svg+xml", body: poster }));
    await page.route("**/host/posters.html", (route) =>
      route.fulfill({
        contentType: "text/html",
        body:
          `<!doctype html><title>Posters</title>
      <meta name="color-scheme" content="light dark"><style>body { margin: 0 } parkade-playground { ` +
          `width: ${width}px; height: ${height}px }</style>
      <script type="module" ` +
          `src="../sub/path/parkade-playground.js"></script><parkade-playground ${attributes} editable="false" ` +
          `reveal="manual" poster="poster.svg"></parkade-playground>`,
      }),
    );
    const visit = async () => {
      await page.goto("/host/posters.html");
      await page.evaluate(() => (document.querySelector("parkade-playground") as Embed).ready);
    };
    await visit();
    poster = await make(page);
    await visit();
    await page.waitForFunction(
      () =>
        document.querySelector("parkade-playground")!.shadowRoot!.querySelector<HTMLImageElement>("img")?.naturalWidth,
    );
    const before = await page.screenshot();
    await page.evaluate(() => (document.querySelector("parkade-playground") as Embed).dismissPoster());
    await expect(page.locator("parkade-playground .poster")).toHaveCount(0);
    await page.mouse.move(width + 10, height + 10);
    let after = before,
      found = await places(page);
    const differing = async () => {
      [after, found] = [await page.screenshot(), await places(page)];
      return (await difference(page, [before, after], found)).share;
    };
    // What is being planned again meanwhile stands back.
    await expect
      .poll(differing)
      .toBeLessThan(MOST_DIFFERENT)
      .finally(async () => {
        await info.attach("poster", { body: before, contentType: "image/png" });
        await info.attach("first frame", { body: after, contentType: "image/png" });
      });
    expect((await difference(page, [before, after], found)).looked).toBeGreaterThan(0.3 * width * height);
  });
}
