import { LitElement, type PropertyValues } from "lit";
import type { App } from "../app/app";
import { number, translate, type MessageKey, type Values } from "../i18n/index";
import type { State } from "../store";

/** Resolves in the frame in which an element has a box, before that is painted. */
function whenVisible(element: Element): Promise<void> {
  return new Promise((done) => {
    const observer = new ResizeObserver(([entry]) => {
      if (!entry || entry.contentRect.width === 0) return;
      observer.disconnect();
      done();
    });
    observer.observe(element);
  });
}

/** A piece of the page: redraws when one of the state's parts it watches changes. */
export abstract class AppElement extends LitElement {
  static override properties = { app: { attribute: false } };
  declare app: App;
  /** Least milliseconds between redraws during a drag, for what the eye does not follow. */
  protected redrawMs = 0;
  /** True if it is only built when there is room for it: many an embedded playground never shows its panels. */
  protected waits = false;
  private room: Promise<void> | null = null;
  private stop: (() => void) | null = null;
  private drawnAt = 0;

  protected abstract watches(): readonly (keyof State)[];

  protected get state(): State {
    return this.app.store.state;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    if (this.app) this.watch();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop?.();
    this.stop = null;
  }

  protected override willUpdate(changed: PropertyValues): void {
    if (changed.has("app") && !this.stop) this.watch();
  }

  // Not the update waits: Lit gives an element that was there before its code the properties of then with the first
  // one.
  protected override shouldUpdate(): boolean {
    if (!this.waits) return true;
    this.room ??= whenVisible(this).then(() => {
      this.waits = false;
      this.requestUpdate("app");
    });
    return false;
  }

  protected override async scheduleUpdate(): Promise<void> {
    const wait =
      this.hasUpdated && this.redrawMs > 0 && this.state.transient
        ? this.drawnAt + this.redrawMs - performance.now()
        : 0;
    if (wait > 0) await new Promise((done) => setTimeout(done, wait));
    this.drawnAt = performance.now();
    super.scheduleUpdate();
  }

  protected t(key: MessageKey, values?: Values): string {
    return translate(this.state.lang, key, values);
  }

  protected num(value: number, digits: number): string {
    return number(this.state.lang, value, digits);
  }

  private watch(): void {
    this.stop?.();
    const keys = [...this.watches(), "lang" as const];
    this.stop = this.app.store.subscribe((state, previous) => {
      if (keys.some((key) => state[key] !== previous[key])) this.requestUpdate();
    });
  }
}
