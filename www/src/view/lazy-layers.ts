/** Pieces of the drawing that the first picture does without: each is fetched when something asks for it. */

import { onScreen } from "./surface";

/** Callbacks for loaded pieces: views that drew without them draw again. */
export const waiting = new Set<() => void>();

/** Null until the piece is there; the first call fetches it. */
export interface Piece<T> {
  (): T | null;
  load(): Promise<T>;
}

/** After a failure, before it is fetched again. */
const PAUSE_MS = 2000;

function piece<T>(fetch: () => Promise<T>): Piece<T> {
  let loaded: T | null = null;
  let loading: Promise<T> | null = null;
  const load = (): Promise<T> =>
    (loading ??= fetch().then(
      (got) => {
        loaded = got;
        for (const draw of waiting) draw();
        return got;
      },
      (error: unknown) => {
        setTimeout(() => {
          loading = null;
        }, PAUSE_MS);
        throw error;
      },
    ));
  const get = (): T | null => {
    if (!loaded) load().catch(() => undefined);
    return loaded;
  };
  return Object.assign(get, { load });
}

/** Maps of very many cells. */
const vastPiece = piece(() => import("./large-map-raster"));
/** Null for files, too: every cell and pose is drawn into those. */
export const vast: Piece<typeof import("./large-map-raster")> = Object.assign(() => (onScreen() ? vastPiece() : null), {
  load: () => vastPiece.load(),
});
/** Contents of the toolbar's menus. */
export const menus = piece(() => import("../panels/toolbar-menus"));
/** Layers for drawing, roads, moving obstacles and search traces. */
export const extras = piece(() => import("../panels/extras"));
