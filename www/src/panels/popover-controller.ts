import type { ReactiveController, ReactiveControllerHost } from "lit";

/** Which of a host's popovers is open; closes on Escape, on a press elsewhere and when focus leaves. */
export class Menus<Name extends string> implements ReactiveController {
  open: Name | null = null;
  private opener: HTMLElement | null = null;

  constructor(private readonly host: ReactiveControllerHost & HTMLElement) {
    host.addController(this);
  }

  hostConnected(): void {
    document.addEventListener("pointerdown", this.onPress, true);
    this.host.addEventListener("keydown", this.onKey);
  }

  hostDisconnected(): void {
    document.removeEventListener("pointerdown", this.onPress, true);
    this.host.removeEventListener("keydown", this.onKey);
  }

  toggle(name: Name, opener: HTMLElement): void {
    this.opener = opener;
    this.open = this.open === name ? null : name;
    this.host.requestUpdate();
    if (this.open) void this.host.updateComplete.then(() => this.items()[0]?.focus());
  }

  close(): void {
    if (!this.open) return;
    this.open = null;
    this.host.requestUpdate();
  }

  private items(): HTMLElement[] {
    return [...(this.host.shadowRoot?.querySelectorAll<HTMLElement>(".popover button, .popover input") ?? [])];
  }

  private readonly onPress = (event: Event): void => {
    const inside = event
      .composedPath()
      .some(
        (node) =>
          node === this.opener ||
          (node instanceof HTMLElement &&
            node.classList.contains("popover") &&
            node.getRootNode() === this.host.shadowRoot),
      );
    if (!inside) this.close();
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    if (!this.open) return;
    if (event.key === "Escape") {
      event.stopPropagation();
      this.close();
      this.opener?.focus();
      return;
    }
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    const items = this.items();
    const now = items.indexOf(this.host.shadowRoot?.activeElement as HTMLElement);
    if (now < 0) return;
    event.preventDefault();
    items[(now + (event.key === "ArrowDown" ? 1 : -1) + items.length) % items.length]?.focus();
  };
}
