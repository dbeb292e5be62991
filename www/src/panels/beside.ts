/** What stands beside a piece of a playground. */
import type { App } from "../app/app";
import type { AppElement } from "./base";

/** The shadow root that a piece of a playground stands in. */
export function rootOf(piece: Node): ShadowRoot {
  const root = piece.getRootNode();
  if (root instanceof ShadowRoot) return root;
  throw new Error(`${piece.nodeName} stands in no playground`);
}

/** The playground around a piece. */
export function hostOf(piece: Node): HTMLElement {
  const { host } = rootOf(piece);
  if (host instanceof HTMLElement) return host;
  throw new Error(`${piece.nodeName} stands in no playground`);
}

/** The element of this kind in the playground of `piece`; it is made where there is none. */
export function besideOf<Kind extends AppElement>(Made: new () => Kind, app: App, piece: Node): Kind {
  const root = rootOf(piece);
  for (const one of root.children) if (one instanceof Made) return one;
  const made = Object.assign(new Made(), { app });
  root.append(made);
  return made;
}
