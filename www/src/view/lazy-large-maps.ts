import { piece } from "./piece";
import { onScreen } from "./surface";

const loaded = piece<typeof import("./large-map-raster")>();
/** Maps of very many cells. Null for files, too: every cell and pose is drawn into those. */
export const vast: typeof loaded = Object.assign(() => (onScreen() ? loaded() : null), {
  load: loaded.load,
  hold: loaded.hold,
  from: loaded.from,
});
