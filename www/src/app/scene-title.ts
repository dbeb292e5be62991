import type { App } from "./app";

/**
 * The scene's title in the page's language, also of a changed preset that came by a link; empty for a drawing without a
 * name.
 */
export function sceneTitle({ preset, catalog, store }: App): string {
  const { scene, lang } = store.state,
    name = preset ?? scene.name;
  return catalog?.scenarios.find(({ id }) => id === name)?.title[lang] ?? scene.name ?? "";
}
