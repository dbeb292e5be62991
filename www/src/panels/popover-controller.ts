import type { ReactiveController, ReactiveControllerHost } from "lit";

/** From a button to its popover, and to the window's edges; CSS pixels. */
const GAP = 6,
  EDGE = 4;

/** After these the button is elsewhere. */
const MOVED = ["resize", "scroll"];

/**
 * Which of a host's popovers is open. The platform has it over everything, and closes it on Escape and on a press
 * elsewhere; its button names it by `popovertarget`, so that a second press closes it.
 */
export class Menus<Name extends string> implements ReactiveController {
  open: Name | null = null;

  constructor(private readonly host: ReactiveControllerHost & HTMLElement) {
    host.addController(this);
  }

  hostConnected(): void {
    this.host.addEventListener("keydown", this.onKey);
    for (const moved of MOVED) addEventListener(moved, this.close);
  }

  hostDisconnected(): void {
    this.host.removeEventListener("keydown", this.onKey);
    for (const moved of MOVED) removeEventListener(moved, this.close);
    this.open = null;
  }

  /** Opens one. Where it is open, the platform closes it by the same press. */
  async toggle(name: Name, opener: HTMLElement): Promise<void> {
    if (this.open === name) return;
    this.open = name;
    // The platform's own answer to the press comes first: it would close what it finds open.
    await new Promise((done) => setTimeout(done));
    this.host.requestUpdate();
    await this.host.updateComplete;
    const { popover } = this;
    if (this.open !== name || !popover) return;
    popover.addEventListener("beforetoggle", ({ newState }) => {
      // Browsers lose the focus that was in another tree than the document's.
      if (newState === "closed" && popover.contains(this.focused)) opener.focus();
    });
    popover.addEventListener("toggle", ({ newState }) => newState === "closed" && this.closed(name));
    popover.showPopover();
    place(popover, opener);
    this.items()[0]?.focus();
  }

  readonly close = (): void => {
    if (!this.open) return;
    if (this.popover?.matches(":popover-open")) this.popover.hidePopover();
    this.closed(this.open);
  };

  private closed(name: Name): void {
    if (this.open !== name) return;
    this.open = null;
    this.host.requestUpdate();
  }

  private get focused(): Element | null {
    return this.host.shadowRoot?.activeElement ?? null;
  }

  private get popover(): HTMLElement | null {
    return this.host.shadowRoot?.querySelector<HTMLElement>(".popover") ?? null;
  }

  private items(): HTMLElement[] {
    return [...(this.popover?.querySelectorAll<HTMLElement>("button, input") ?? [])];
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    if (!this.open) return;
    // The page's own Escape gives up what is being drawn.
    if (event.key === "Escape") event.stopPropagation();
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    const items = this.items(),
      now = items.indexOf(this.focused as HTMLElement);
    if (now < 0) return;
    event.preventDefault();
    items[(now + (event.key === "ArrowDown" ? 1 : -1) + items.length) % items.length]?.focus();
  };
}

/**
 * Below its button or, where there is no room, above; `right`: their right sides are in line; `beside`: to the right of
 * it.
 */
function place(popover: HTMLElement, opener: HTMLElement): void {
  const { left, right, top, bottom } = opener.getBoundingClientRect(),
    { offsetWidth: width, offsetHeight: height, classList } = popover;
  const below = bottom + GAP,
    isBeside = classList.contains("beside");
  const x = isBeside ? right + GAP : classList.contains("right") ? right - width : left,
    y = isBeside ? top : below + height <= innerHeight - EDGE ? below : top - GAP - height;
  popover.style.left = `${Math.max(EDGE, Math.min(x, innerWidth - width - EDGE))}px`;
  popover.style.top = `${Math.max(EDGE, Math.min(y, innerHeight - height - EDGE))}px`;
}
