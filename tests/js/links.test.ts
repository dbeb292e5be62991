import { afterEach, expect, it, vi } from "vitest";
import { init, scenario } from "parkade";
import { LinkSync } from "../../www/src/app/link-sync";
import { encodeScene } from "../../www/src/scene/link";
import { messageOf } from "../../www/src/i18n/said";
import { ensureIds } from "../../www/src/scene/model";
import { createStore } from "../../www/src/store";

afterEach(() => vi.unstubAllGlobals());

it("a link with a view keeps it, also while the address of the scene before is about to be written", async () => {
  await init();
  const scene = ensureIds(scenario("perpendicular")),
    place = { hash: "", href: "https://example.org/" };
  let arrive = (): void => {};
  vi.stubGlobal("location", place);
  vi.stubGlobal("history", {
    state: null,
    replaceState: (_: unknown, __: string, href: string) => {
      Object.assign(place, { href, hash: new URL(href).hash });
    },
  });
  vi.stubGlobal("addEventListener", (type: string, listener: () => void) => {
    if (type === "hashchange") arrive = listener;
  });
  const store = createStore({ scene }),
    views: (readonly string[] | undefined)[] = [];
  const sync = new LinkSync(
    store,
    async (_, view) => void views.push(view?.planners),
    () => undefined,
  );
  sync.start();
  store.edit({ ...scene, name: "Drawn" });
  const writing = sync.write();
  place.hash = `#s=${await encodeScene(scene)}&v=0~four~four.eight~4mf~0~10000`;
  place.href = `https://example.org/${place.hash}`;
  arrive();
  await writing;
  expect(place.hash).toContain("&v=");
  await vi.waitFor(() => expect(views).toEqual([["four", "eight"]]));
});

it("of two links that come at once only the last one is opened, however long the first takes to read", async () => {
  await init();
  const scene = ensureIds(scenario("perpendicular")),
    place = { hash: "", href: "https://example.org/" };
  let arrive = (): void => {};
  vi.stubGlobal("location", place);
  vi.stubGlobal("addEventListener", (type: string, listener: () => void) => {
    if (type === "hashchange") arrive = listener;
  });
  const opened: (string | undefined)[] = [],
    refused: string[] = [];
  const sync = new LinkSync(
    createStore({}),
    async ({ name }) => void opened.push(name),
    (error) => refused.push(messageOf(error)),
  );
  sync.start();
  const boxes = Array.from({ length: 1500 }, (_, i) => ({
    type: "rectangle" as const,
    id: `b${i}`,
    center: [Math.sin(i) * 9, 20 + Math.cos(i * 7)] as [number, number],
    size: [0.05, 0.05] as [number, number],
    heading: i,
  }));
  const links = [
    await encodeScene({ ...scene, name: "First", obstacles: boxes }),
    "1damaged",
    await encodeScene({ ...scene, name: "Last" }),
  ];
  for (const link of links) {
    place.hash = `#s=${link}`;
    arrive();
  }
  await vi.waitFor(() => expect(opened).toContain("Last"));
  await new Promise((done) => setTimeout(done, 500));
  expect([opened, refused]).toEqual([["Last"], []]);
});
