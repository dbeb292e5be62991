/** Texts that the export menu copies: the scene in a form to paste. */
import "../i18n/later";
import { forPlanners } from "../scene/large-scene";
import { refusal, type App } from "./app";
import { sceneTitle } from "./scene-title";

export type SnippetKind = "embed" | "markdown" | "test";

const MAKERS: Record<SnippetKind, (app: App) => Promise<string>> = {
  embed: embedSnippet,
  markdown: markdownLink,
  test: nodeTest,
};

/** Copies a snippet and says so, or why not. */
export async function copySnippet(app: App, kind: SnippetKind): Promise<void> {
  try {
    if (await app.copy(await MAKERS[kind](app))) app.notify("info", "bar.copied");
  } catch (error) {
    app.refuse("error.export", { reason: refusal(error) });
  }
}

/** A quotation mark or a `</script>` in a name must stay text. */
const asAttribute = (text: string): string =>
  text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
const asScript = (value: unknown): string => JSON.stringify(value).replaceAll("<", "\\u003c");

async function embedSnippet(app: App): Promise<string> {
  const { planners, mode } = app.store.state;
  const root = new URL(".", location.href.split("#")[0]).href;
  return (
    `<script type="module" src="${asAttribute(root)}parkade-playground.js"></script>
<parkade-playground ` +
    `planners="${planners.join(" ")}" layout="${mode}" controls="minimal" alt="${asAttribute(sceneTitle(app))}">
<script type="application/json" slot="scene">${asScript(await sceneOf(app))}</script>
</parkade-playground>
`
  );
}

async function markdownLink(app: App): Promise<string> {
  const href = await app.links.address(true);
  if (!href) throw new Error(app.t("error.longLink"));
  return `[${(sceneTitle(app) || "Parkade").replace(/[\\[\]]/g, "\\$&")}](${href})`;
}

/** Holds the focused planner's own answer by its hash. */
async function nodeTest(app: App): Promise<string> {
  const { focus, results } = app.store.state,
    result = results[focus],
    plan = (result?.chosen && result.ordinary) ?? result?.plan;
  if (!plan) throw new Error(app.t("error.noPath"));
  return `import assert from "node:assert/strict";
import { test } from "node:test";
import { Planner, init } from "parkade";

const scene = ${JSON.stringify(await sceneOf(app), null, 2)};

test(${JSON.stringify(`${focus}: ${app.store.state.scene.name || "a scene"}`)}, async () => {
  await init();
  const planner = new Planner(${JSON.stringify(focus)}, scene);
  const plan = planner.plan();
  planner.free();
  assert.equal(plan.outcome, ${JSON.stringify(plan.outcome)});
  assert.equal(plan.hash, ${JSON.stringify(plan.hash)});
});
`;
}

const sceneOf = async (app: App): Promise<unknown> =>
  forPlanners(app.store.state.scene, (await app.complete()).api.packRuns);
