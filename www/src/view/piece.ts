/**
 * Pieces that the first picture does without: each is fetched when something asks for it, from where the page's root
 * says.
 */

/** Callbacks for loaded pieces: views that drew without them draw again. */
export const waiting = new Set<() => void>();

export interface Piece<T> {
  /** Null until the piece is there; the first call fetches it. */
  (): T | null;
  load(): Promise<T>;
  /** Names where the piece comes from. One that comes from nowhere is never there. */
  from(fetch: () => Promise<T>): void;
  /**
   * Has the piece at hand from now on; where a page has named the whole one, a file's part of it does not take its
   * place.
   */
  hold(piece: T): void;
}

/** After a failure, before it is fetched again. */
const PAUSE_MS = 2000;

export function piece<T>(fetch?: () => Promise<T>): Piece<T> {
  let loaded: T | null = null;
  let loading: Promise<T> | null = null;
  const hold = (got: T): T => {
    loaded = got;
    for (const draw of waiting) draw();
    return got;
  };
  const load = (): Promise<T> =>
    (loading ??= (fetch?.() ?? Promise.reject(new Error("nobody named the piece"))).then(hold, (error: unknown) => {
      setTimeout(() => {
        loading = null;
      }, PAUSE_MS);
      throw error;
    }));
  const get = (): T | null => {
    if (!loaded && fetch) load().catch(() => undefined);
    return loaded;
  };
  const from = (source: () => Promise<T>): void => {
    fetch = source;
  };
  const keep = (own: T): void => {
    if (!fetch) hold(own);
  };
  return Object.assign(get, { load, hold: keep, from });
}
