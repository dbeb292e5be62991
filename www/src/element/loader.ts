import type { Embedded } from "./embedded";
import { ATTRIBUTES, METHODS, PARTS, READABLE, SETTABLE } from "./public-api";

/** How near to the window a lazy playground begins to load. */
const NEAR = "400px";

/** The build puts the file's name here. */
const EMBEDDED = "./embedded";

/** Servers that render pages import this file, and have neither elements nor styles. */
const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;
const style = globalThis.CSSStyleSheet && new CSSStyleSheet();
style?.replaceSync(
  `
:host { display: block; box-sizing: border-box; width: 100%; position: relative; contain: content; aspect-ratio: 12 ` +
    `/ 7; min-height: 280px; overflow: hidden; background: var(--parkade-bg, Canvas); }
:host([hidden]) { display: none; }
parkade-embedded, .poster { position: absolute; inset: 0; }
parkade-embedded.covered { visibility: hidden; }
.poster { display: block; width: 100%; height: 100%; z-index: 1; border: 0; padding: 0; margin: 0; background: ` +
    `none; font: inherit; color: inherit; cursor: default; }
button.poster { cursor: pointer; }
.poster img, ::slotted([slot=poster]) { display: block; width: 100%; height: 100%; object-fit: contain; ` +
    `object-position: top; }
.bar { position: absolute; z-index: 2; inset: auto 0 0; height: 3px; background: var(--parkade-accent, Highlight); ` +
    `transform: scaleX(0); transform-origin: left; transition: transform .2s; }
`,
);

type Name = (typeof METHODS)[number];

/**
 * What is made from the lists in `vocabulary.ts`; every method gives a promise, because its code may have to come
 * first.
 */
export interface ParkadePlayground extends Record<Name, (...args: never[]) => Promise<unknown>> {
  setScene(scene: import("parkade").Scenario): Promise<void>;
  openLink(link: string): Promise<void>;
  sceneData: import("parkade").Scenario | undefined;
}

/**
 * `<parkade-playground>` in other people's pages. Until it is wanted it is a picture: nothing else is fetched. Its own
 * attributes are `loading` (auto and lazy: when it comes near; eager: at once), `reveal` (auto; interaction: loads when
 * pressed; manual: the poster stays until `dismissPoster()`), `poster` and `alt`; the others belong to `Embedded`.
 */
export class ParkadePlayground extends Base {
  static readonly observedAttributes = [...ATTRIBUTES, "poster", "alt", "loading", "reveal"];

  /**
   * Resolves when the first scene is planned; rejects where it cannot be opened, and is another promise once a valid
   * one follows.
   */
  ready!: Promise<void>;
  private settle!: { ready(): void; failed(error: unknown): void };
  private readonly root = this.attachShadow({ mode: "open" });
  private inner: Embedded | null = null;
  private starting: Promise<Embedded> | null = null;
  private readonly early = new Map<string, unknown>();
  private readonly observer = new IntersectionObserver(
    (entries) => this.near(entries.some((entry) => entry.isIntersecting)),
    { rootMargin: NEAR },
  );
  private dismissed = false;

  constructor() {
    super();
    this.renew();
    this.root.adoptedStyleSheets = [style];
    this.cover();
    // What was set before this class was there hides its accessors.
    for (const name of SETTABLE) {
      if (!Object.hasOwn(this, name)) continue;
      const value: unknown = Reflect.get(this, name);
      Reflect.deleteProperty(this, name);
      Reflect.set(this, name, value);
    }
  }

  private renew(): void {
    this.ready = new Promise((ready, failed) => {
      this.settle = { ready, failed };
    });
    this.ready.catch(() => undefined);
  }

  get loaded(): boolean {
    return this.inner?.loaded ?? false;
  }

  connectedCallback(): void {
    if (this.mode("loading") === "eager" && this.mode("reveal") !== "interaction")
      void this.load().catch(() => undefined);
    else if (!this.starting) this.observer.observe(this);
  }

  disconnectedCallback(): void {
    this.observer.disconnect();
  }

  attributeChangedCallback(name: string, old: string | null, value: string | null): void {
    if (old === value) return;
    if (name === "poster" || name === "alt" || name === "reveal") this.cover();
    else if (name === "loading") {
      if (this.isConnected) this.connectedCallback();
    } else if (this.inner) this.pass(this.inner, name);
  }

  /** Shows what is alive, loading it if need be. */
  dismissPoster(): Promise<void> {
    this.dismissed = true;
    return this.load()
      .then((inner) => inner.ready)
      .then(() => this.uncover());
  }

  /** The element that does the work, once its code is there. */
  load(): Promise<Embedded> {
    this.observer.disconnect();
    return (this.starting ??= this.start().catch((error: unknown) => {
      this.starting = null;
      this.settle.failed(error);
      this.emit("error", { code: "load", message: String(error instanceof Error ? error.message : error) });
      throw error;
    }));
  }

  private async start(): Promise<Embedded> {
    this.progress(0.1);
    const { Embedded, colours } = (await import(
      /* @vite-ignore */ new URL(EMBEDDED, import.meta.url).href
    )) as typeof import("./embedded");
    this.progress(0.4);
    if (colours.styleSheet) this.root.adoptedStyleSheets = [colours.styleSheet, style];
    const inner = new Embedded();
    inner.className = "covered";
    inner.setAttribute("exportparts", PARTS.join());
    const extra = document.createElement("slot");
    extra.name = extra.slot = "toolbar-extra";
    inner.append(extra);
    inner.inline = this.sceneText();
    inner.onStep = (share) => this.progress(share);
    inner.onTheme = (theme) => this.setAttribute("theme", theme);
    for (const name of ATTRIBUTES) this.pass(inner, name);
    // The rules of its own attributes come with the other code.
    for (const name of ["loading", "reveal"]) inner.attributeChangedCallback(name, null, this.getAttribute(name));
    this.inner = inner;
    // What went wrong is said below the poster.
    inner.addEventListener("error", () => this.uncover(), { once: true });
    const follow = (): void =>
      void inner.ready.then(
        () => this.live(),
        (error: unknown) => this.settle.failed(error),
      );
    follow();
    inner.onRenew = () => {
      this.renew();
      follow();
    };
    this.root.append(inner);
    for (const [name, value] of this.early) Reflect.set(inner, name, value);
    this.early.clear();
    return inner;
  }

  /** Site generators drop or run scripts inside a page's text, so any element may hold the scene. */
  private sceneText(): string | null {
    const holder = this.querySelector('[slot="scene"]');
    return (holder instanceof HTMLTemplateElement ? holder.content : holder)?.textContent ?? null;
  }

  private live(): void {
    this.progress(1);
    this.settle.ready();
    if (this.mode("reveal") !== "manual" || this.dismissed) this.uncover();
  }

  private near(isNear: boolean): void {
    if (isNear && this.mode("reveal") !== "interaction") void this.load().catch(() => undefined);
  }

  private pass(inner: HTMLElement, name: string): void {
    const value =
      this.getAttribute(name) ?? (name === "lang" ? (this.closest("[lang]")?.getAttribute("lang") ?? null) : null);
    if (value === null) inner.removeAttribute(name);
    else if (inner.getAttribute(name) !== value) inner.setAttribute(name, value);
  }

  /** The poster, from the slot or the attribute, over what loads behind it. */
  private cover(): void {
    if (this.loaded) return;
    this.root.querySelector(".poster")?.remove();
    const waits = this.mode("reveal") === "interaction";
    const poster = document.createElement(waits ? "button" : "div");
    poster.className = "poster";
    poster.setAttribute("part", "poster");
    const slot = document.createElement("slot");
    slot.name = "poster";
    const url = this.getAttribute("poster"),
      alt = this.getAttribute("alt") ?? "";
    if (url) {
      const image = document.createElement("img");
      image.src = url;
      image.alt = alt;
      slot.append(image);
    }
    poster.append(slot);
    if (waits) {
      poster.ariaLabel = alt || "Parkade";
      poster.onclick = () =>
        void this.dismissPoster()
          .then(() => this.inner?.focus())
          .catch(() => undefined);
    }
    this.root.append(poster);
  }

  private uncover(): void {
    if (!this.inner) return;
    const { inner } = this;
    void inner.drawn().then(() => {
      inner.className = "";
      this.root.querySelectorAll(".poster, slot[name=progress]").forEach((node) => node.remove());
    });
  }

  private progress(totalProgress: number): void {
    let slot = this.root.querySelector<HTMLSlotElement>("slot[name=progress]");
    if (!slot && totalProgress < 1) {
      slot = document.createElement("slot");
      slot.name = "progress";
      const bar = document.createElement("div");
      bar.className = "bar";
      bar.setAttribute("part", "progress");
      slot.append(bar);
      this.root.append(slot);
    }
    slot?.querySelector<HTMLElement>(".bar")?.style.setProperty("transform", `scaleX(${totalProgress})`);
    if (totalProgress >= 1) slot?.remove();
    this.emit("progress", { totalProgress });
  }

  private mode(name: string): string {
    return this.getAttribute(name) ?? "auto";
  }

  private emit(name: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(name, { detail, composed: true }));
  }

  /** For what is known only when the work is done elsewhere. */
  private static forward(): void {
    const { prototype } = ParkadePlayground;
    for (const name of METHODS) {
      Object.defineProperty(prototype, name, {
        configurable: true,
        writable: true,
        value(this: ParkadePlayground, ...args: unknown[]) {
          return this.load().then(async (inner) => {
            // A scene that is set mends what a wrong one broke.
            if (name !== "setScene") await inner.ready;
            else await inner.ready.catch(() => undefined);
            return Reflect.apply(inner[name], inner, args);
          });
        },
      });
    }
    const read = (name: string) =>
      function get(this: ParkadePlayground): unknown {
        return this.early.get(name) ?? (this.inner ? Reflect.get(this.inner, name) : undefined);
      };
    for (const name of READABLE) Object.defineProperty(prototype, name, { get: read(name) });
    for (const name of SETTABLE) {
      Object.defineProperty(prototype, name, {
        get: read(name),
        set(this: ParkadePlayground, value: unknown) {
          if (this.inner) Reflect.set(this.inner, name, value);
          else this.early.set(name, value);
        },
      });
    }
    for (const name of [...ATTRIBUTES, "poster", "alt", "loading", "reveal"]) {
      const property = name.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase());
      if (property in prototype && property !== "lang") continue;
      if (property === "lang") continue;
      Object.defineProperty(prototype, property, {
        get(this: HTMLElement) {
          return ["editable", "autoplay"].includes(name) ? this.hasAttribute(name) : this.getAttribute(name);
        },
        set(this: HTMLElement, value: unknown) {
          if (value === null || value === undefined || value === false) this.removeAttribute(name);
          else this.setAttribute(name, value === true ? "" : String(value));
        },
      });
    }
  }

  static {
    this.forward();
  }
}

if (globalThis.customElements && !customElements.get("parkade-playground"))
  customElements.define("parkade-playground", ParkadePlayground);
