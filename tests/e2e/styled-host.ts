/** A page with one playground, dressed by the page's own style. */
import type { Page } from "@playwright/test";

export interface Embed extends HTMLElement {
  ready: Promise<void>;
  dismissPoster(): Promise<void>;
  settled(): Promise<void>;
}

/** `attributes` of the playground, `css` of the page, and what is in the element. */
export async function visit(page: Page, attributes: string, css: string, inside = ""): Promise<void> {
  await page.emulateMedia({
    reducedMotion: attributes.includes("autoplay") ? "no-preference" : "reduce",
    colorScheme: "light",
  });
  await page.setViewportSize({ width: 1300, height: 800 });
  await page.route("**/host/styled.html", (route) =>
    route.fulfill({
      contentType: "text/html",
      body:
        `<!doctype html><title>Styled</title><style>parkade-playground { width: 1280px; height: 760px ` +
        `} ${css}</style>
    <script type="module" ` +
        `src="../sub/path/parkade-playground.js"></script>` +
        `<parkade-playground ${attributes}>${inside}</parkade-playground>`,
    }),
  );
  await page.goto("/host/styled.html");
}

export const ready = (page: Page) =>
  page.evaluate(async () => {
    const element = document.querySelector("parkade-playground") as Embed;
    await element.ready;
    await element.settled();
  });
