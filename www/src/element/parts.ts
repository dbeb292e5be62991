import { extras, menus, vast } from "../view/lazy-layers";

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
extras.from(() => import("../panels/extras"));
menus.from(() => import("../panels/toolbar-menus"));
vast.from(() => import("../view/large-map-raster"));
