/** Makes the figures of a page live when they come near the window, and keeps what the reader has done. */
import { figureOf } from "./figures";
import { startGrid } from "./grid-lab";
import { startMetric } from "./metric-lab";
import { finished, finish } from "./progress";
import { word, type Lang } from "./words";

type Package = typeof import("parkade");
let loading: Promise<Package> | undefined;

/** The package, with its module loaded; asked for again after a failure. */
function engine(): Promise<Package> {
  loading ??= load().catch((error: unknown) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

async function load(): Promise<Package> {
  const parkade = (await import("../../../pkg/index.js")) as unknown as Package;
  await parkade.init();
  return parkade;
}

/** How far from the window a figure begins to load. */
const NEAR = "300px";

export function enliven(page: ParentNode): void {
  const watch = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        watch.unobserve(target);
        void start(target as HTMLElement);
      }
    },
    { rootMargin: NEAR },
  );
  for (const root of page.querySelectorAll<HTMLElement>("figure[data-lab]:not([data-live])")) {
    root.dataset["live"] = "no";
    if (finished(root.dataset["lab"]!)) reveal(root);
    watch.observe(root);
  }
}

async function start(root: HTMLElement): Promise<void> {
  const id = root.dataset["lab"]!,
    lang = root.dataset["lang"] as Lang;
  try {
    const figure = figureOf(id),
      parkade = await engine();
    const done = (): void => {
      finish(id);
      reveal(root);
    };
    if (figure.kind === "grid") startGrid(root, figure, parkade, lang, done);
    else startMetric(root, figure, parkade, lang, done);
    root.dataset["live"] = "yes";
  } catch (error) {
    root.dataset["live"] = "failed";
    root.querySelector(".lab-readout")!.textContent = word("failed", lang);
    console.error(error);
  }
}

function reveal(root: HTMLElement): void {
  root.dataset["done"] = "yes";
  root.querySelector(".lab-todo")!.textContent = word("done", root.dataset["lang"] as Lang);
}
