import type { PlannerId } from "parkade";
import type { Known } from "./schema";
import { fitsLink } from "../scene/large-scene";
import type { Scene, State, Store } from "../store";

const PREFIX = "#s=",
  VIEW = "&v=";
const SETTLE_MS = 500;
/** Longer addresses are cut off by chats and mail. */
export const LINK_LIMIT = 8000;

/** Nothing of it is needed before the first picture, unless that comes by a link. */
const linkFormat = () => import("../scene/link");
const viewFormat = () => import("./view-link");

/**
 * A link's view: what it names, and what that is where these planners and this map are known; `read` throws where it
 * makes no sense.
 */
export interface LinkView {
  planners: PlannerId[];
  read(known: Known): Partial<State>;
}

/** Keeps the address in step with the scene, and reads scenes from it. */
export class LinkSync {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private unsubscribe: (() => void) | null = null;
  private readonly onHash = (): void => void this.arrive();
  /** A reload opens the address it began with, however late the server answers; the history is kept for that one. */
  private readonly onLeaving = (): void => void (this.leaving = true);
  private leaving = false;
  private written = "";
  private turn = 0;
  private marking = Promise.resolve();

  constructor(
    private readonly store: Store,
    private readonly open: (scene: Scene, view: LinkView | null) => Promise<void>,
    private readonly refuse: (error: unknown) => void,
  ) {}

  start(): void {
    addEventListener("hashchange", this.onHash);
    addEventListener("beforeunload", this.onLeaving);
    this.unsubscribe = this.store.subscribe((state, previous) => {
      if (state.scene === previous.scene) return;
      // Whoever draws has stayed.
      this.leaving = false;
      clearTimeout(this.timer);
      // A mark that takes longer names the scene before it.
      this.timer = setTimeout(() => void this.marking.finally(() => this.write()), SETTLE_MS);
    });
  }

  stop(): void {
    removeEventListener("hashchange", this.onHash);
    removeEventListener("beforeunload", this.onLeaving);
    this.unsubscribe?.();
    clearTimeout(this.timer);
  }

  /**
   * The address of `page` that opens the present scene, if wanted as it is looked at; null when it would be too long.
   */
  async address(looks = false, page = location.href): Promise<string | null> {
    const { scene } = this.store.state,
      url = new URL(page);
    if (!fitsLink(scene)) return null;
    const { encodeScene } = await linkFormat();
    url.hash =
      PREFIX.slice(1) +
      (await encodeScene(scene)) +
      (looks ? VIEW + (await viewFormat()).encodeView(this.store.state) : "");
    return url.href.length > LINK_LIMIT ? null : url.href;
  }

  /** The scene in the present address; null without one. Rejects when it cannot be read. */
  async read(hash = location.hash): Promise<Scene | null> {
    return hash.startsWith(PREFIX) ? (await linkFormat()).decodeScene(hash.slice(PREFIX.length)) : null;
  }

  /** How the scene in the present address is looked at; null where it does not say. */
  async view(hash = location.hash): Promise<LinkView | null> {
    const at = hash.indexOf(VIEW);
    if (at < 0) return null;
    const text = hash.slice(at + VIEW.length),
      { plannersOf, decodeView } = await viewFormat();
    return { planners: plannersOf(text), read: (known) => decodeView(text, known, this.store.state.playback) };
  }

  async write(): Promise<string | null> {
    clearTimeout(this.timer);
    const { hash } = location,
      href = await this.address();
    if (href && href !== location.href && hash === location.hash && !this.leaving) {
      this.written = new URL(href).hash;
      history.replaceState(history.state, "", href);
    }
    return href;
  }

  /** Leaves the present scene in the history, for the way back from the next one. */
  mark(): Promise<void> {
    return (this.marking = this.leaveMark());
  }

  private async leaveMark(): Promise<void> {
    if (this.unsubscribe && (await this.write())) history.pushState(history.state, "", location.href);
  }

  private async arrive(): Promise<void> {
    if (location.hash === this.written) return;
    const hash = (this.written = location.hash),
      turn = ++this.turn;
    // The address of the scene before it is not to be written over it.
    clearTimeout(this.timer);
    try {
      const scene = await this.read(hash),
        view = await this.view(hash);
      // Another one may have come meanwhile.
      if (scene && turn === this.turn) await this.open(scene, view);
    } catch (error) {
      if (turn === this.turn) this.refuse(error);
    }
  }
}
