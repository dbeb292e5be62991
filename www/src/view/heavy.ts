/** Drawing of what is too much for paths; fetched when there is such a thing. */
type Vast = typeof import("./vast");

let loaded: Vast | null = null;
let loading: Promise<Vast> | null = null;

/** What is called when it has come: whoever drew without it draws again. */
export const waiting = new Set<() => void>();

export function loadVast(): Promise<Vast> {
  return (loading ??= import("./vast").then((vast) => {
    loaded = vast;
    for (const draw of waiting) draw();
    return vast;
  }));
}

/** Null until it is there: until then paths are drawn. */
export function vast(): Vast | null {
  if (!loaded) void loadVast();
  return loaded;
}
