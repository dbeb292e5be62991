import type { App } from "../app/app";
import { laterTexts } from "../panels/lazy-texts";
import { vast } from "../view/lazy-large-maps";
import { laterLayers } from "../view/lazy-layers";

/** Parts after the first picture, fetched at once or when opened. */
export const PARTS = [
  () => import("../panels/toolbar"),
  () => import("../panels/table"),
  () => import("../panels/inspector"),
  () => import("../panels/charts"),
  () => import("../panels/options"),
  () => import("../panels/view-controls"),
  () => import("../panels/splitter"),
];
const extras = () => import("../panels/extras");
laterLayers.from(extras);
laterTexts.from(extras);
vast.from(() => import("../view/large-map-raster"));

/** What follows the store comes as soon as there is a scene. */
export const follow = (app: App): Promise<void> =>
  extras().then(
    (extra) => extra.follow(app),
    () => undefined,
  );
