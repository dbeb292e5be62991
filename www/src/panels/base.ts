import { LitElement, type PropertyValues } from "lit";
import type { App } from "../element/app";
import { number, translate, type MessageKey, type Values } from "../i18n/index";
import type { State } from "../store";

/** A piece of the page: redraws when one of the state's parts it watches changes. */
export abstract class AppElement extends LitElement {
  static override properties = { app: { attribute: false } };
  declare app: App;
  private stop: (() => void) | null = null;

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
