import type { Scene } from "../store";
import { refusal } from "../app/app";
import { Playground } from "./playground";
import { oneOf, ValueError } from "../app/schema";
import { messageOf } from "../i18n/said";
import { fieldsOf } from "../scene/records";

/**
 * Events of other elements have these names too, and pages listen for them further out; `error` would reach
 * `window.onerror`.
 */
const OWN_EVENTS: readonly string[] = ["error", "select"];

/**
 * How an embedded playground gets its scenes, and says what is wrong with them. A scene that cannot be opened leaves
 * room for the next one.
 */
export abstract class SceneOpening extends Playground {
  declare src: string | null;
  /** A scene written into the page. */
  inline: string | null = null;
  /** Told when `ready` is another promise than before. */
  onRenew: () => void = () => {};
  private becomeFailed: (error: unknown) => void = () => {};
  /** Why there is no first scene. */
  protected failure: unknown = null;
  /** The scene that is asked for in place of one that could not be opened. */
  private wanted: Scene | null = null;

  constructor() {
    super();
    this.src = null;
    this.renew();
  }

  override set sceneData(scene: Scene) {
    if (this.loaded) this.takeScene(scene);
    else
      void this.ready.then(
        () => this.takeScene(scene),
        () => this.retry(plain(scene)),
      );
  }

  override get sceneData(): Scene {
    return super.sceneData;
  }

  protected override async begin(): Promise<void> {
    const { loaded: again } = this;
    try {
      await this.app.start({ ...this.beginning(), loaded: () => this.becomeLoaded() });
      if (!this.loaded) return;
      this.becomeReady();
      if (!again) this.emit("ready", {});
    } catch (error) {
      await this.failed(error);
    }
  }

  /** Says why there is no first scene, unless all it takes is the whole module. */
  private async failed(error: unknown): Promise<void> {
    let cause = error;
    if (fieldsOf(error)["code"] === "unknown-scenario") {
      if (!this.store.state.complete)
        return this.app.complete().then(
          () => this.begin(),
          (reason: unknown) => this.failed(reason),
        );
      cause = this.unknownScene(this.scene);
    }
    this.failure = cause;
    this.app.refuse("error.load", { reason: refusal(cause) });
    this.becomeFailed(cause);
  }

  protected unknownScene(id: string): ValueError | null {
    const fault = oneOf(this.app.catalog!.scenarios.map((one) => one.id))(id, "scene");
    return fault && new ValueError(fault);
  }

  /** The first scene did not come; another one is as good. */
  protected retry(scene: Scene | null): void {
    this.app.stop();
    this.failure = null;
    this.wanted = scene;
    this.store.set({ message: null });
    this.renew();
    void this.begin();
  }

  private renew(): void {
    this.ready = new Promise((resolve, reject) => {
      this.becomeReady = resolve;
      this.becomeFailed = reject;
    });
    this.ready.catch(() => undefined);
    this.onRenew();
  }

  /** Runs a change when there is a scene to change. */
  protected later(run: () => void | Promise<void>): void {
    void (this.loaded ? this.change(run) : this.ready.then(() => this.change(run))).catch(() => undefined);
  }

  /** Rejects, and says so, where the change is refused. */
  protected async change(run: () => unknown): Promise<void> {
    try {
      await run();
    } catch (error) {
      this.emitRefusal(error);
      throw error;
    }
  }

  /** Nothing has changed, and this is why: which field, what it was, and what it must be. */
  protected emitRefusal(error: unknown): void {
    const { field = "", value, rule = "", path = field, code = "value" } = fieldsOf(error);
    this.emit("error", { code, field: path || field, value, rule, message: messageOf(error) });
  }

  protected override emit(name: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: !OWN_EVENTS.includes(name), composed: true }));
  }

  /** The scene from `src` or from the page; null leaves it to `scene`. */
  protected async given(): Promise<Scene | null> {
    if (this.wanted) return this.wanted;
    if (this.src) return fetched(this.src);
    if (this.inline === null) return null;
    try {
      return JSON.parse(this.inline);
    } catch (error) {
      throw new ValueError({ field: "scene", value: this.inline, rule: "scene", why: messageOf(error) });
    }
  }
}

async function fetched(src: string): Promise<Scene> {
  const refuse = (why: string, rule: "address" | "answered" = "address"): ValueError =>
    new ValueError({ field: "src", value: src, rule, why });
  let answer: Response;
  try {
    answer = await fetch(new URL(src, document.baseURI));
  } catch (error) {
    throw refuse(messageOf(error));
  }
  if (!answer.ok) throw refuse(String(answer.status), "answered");
  try {
    return await answer.json();
  } catch (error) {
    throw refuse(messageOf(error));
  }
}

/** Frameworks wrap data in proxies, which no worker can be sent. */
export function plain(scene: Scene): Scene {
  try {
    return structuredClone(scene);
  } catch {
    return unwrapped(scene) as Scene;
  }
}

function unwrapped(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(unwrapped);
  if (typeof value !== "object" || value === null || ArrayBuffer.isView(value)) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, unwrapped(one)]));
}
