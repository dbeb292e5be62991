/** Pieces of the drawing that the first picture does without: each is fetched when something asks for it. */

import { onScreen } from "./surface";

/** What is called when a piece has come: whoever drew without it draws again. */
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
/** What the toolbar's menus hold. */
export const menus = piece(() => import("../panels/toolbar-menus"));
/** What comes with drawing, roads, moving obstacles and a closer look at searches. */
export const extras = piece(() => import("../panels/extras"));
