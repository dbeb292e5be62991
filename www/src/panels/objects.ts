import type { Selection } from "../scene/selection";
import type { Pose } from "parkade";
import type { Obstacle } from "../scene/scenario";
import { css, html, type TemplateResult } from "lit";
import { takesKey } from "../app/keyboard";
import { number, translate, type Lang } from "../i18n/index";
import messages from "../i18n/messages/objects.json";
import { translator } from "../i18n/translator";
import { countCells, type Run } from "../scene/cells";
import { goalPose } from "../scene/model";
import { idsOf } from "../scene/scene-objects";
import type { State } from "../store";
import { controls } from "../styles/controls";
import { sections } from "../styles/sections";
import { AppElement } from "./base";
import { icon, type IconName } from "../styles/icons";
import { nth } from "../scene/nth";

const say = translator("objects", messages);

interface Item {
  key: string;
  icon: IconName;
  name: string;
  detail: string;
  selection: NonNullable<Selection>;
}

const ICONS: Record<Obstacle["type"], IconName> = {
  cells: "brush",
  wall: "wall",
  polygon: "polygon",
  rectangle: "rectangle",
  car: "car",
  road: "road",
};

/** Everything in the scene by name: the way to it without a pointer. */
export class ObjectList extends AppElement {
  static override styles = [
    controls,
    sections,
    css`
    ul { list-style: none; margin: 0 -8px; padding: 0; }
    li button { width: 100%; height: 27px; padding: 0 8px; gap: 10px; justify-content: flex-start; }
    li button:hover { background: var(--parkade-hover); }
    li button[aria-pressed="true"] {
      background: var(--parkade-accent-soft); box-shadow: inset 0 0 0 1px var(--parkade-accent);
    }
    li span:last-child {
      margin-left: auto; color: var(--parkade-t2); font-size: 12px; overflow: hidden; text-overflow: ellipsis;
    }
    li svg { color: var(--parkade-t2); }
    @media (pointer: coarse) { li button { height: 44px; } }
  `,
  ];

  protected override redrawMs = 100;
  protected watches(): readonly (keyof State)[] {
    return ["scene", "selection"];
  }

  protected override render(): TemplateResult {
    const items = itemsOf(this.state);
    const now = this.state.selection;
    return html`<div class="head"><h2>${this.t("inspect.objects")}</h2><span>${items.length}</span></div>
      <ul>${items.map(
        (item) => html`<li><button aria-pressed=${isSame(item.selection, now)} @click=${() => this.pick(item)}
          @keydown=${(e: KeyboardEvent) => this.key(e, item)}>
        ${icon(item.icon)}<span>${item.name}</span><span>${item.detail}</span></button></li>`,
      )}</ul>`;
  }

  private pick(item: Item): void {
    this.app.store.set({ selection: item.selection, tool: "select" });
  }

  /** Arrow keys and Delete work on an object from here as on the map. */
  private key(event: KeyboardEvent, item: Item): void {
    if (!/^(Arrow|Delete|Backspace)/.test(event.key)) return;
    this.pick(item);
    if (takesKey(this.app, event)) {
      event.preventDefault();
      event.stopPropagation();
    }
  }
}

/** Cones are polygons to the planners; their ids tell them apart here. */
const isCone = ({ type, id }: Obstacle): boolean => type === "polygon" && /^cone-\d+$/.test(id ?? "");

export function objectName(lang: Lang, obstacle: Obstacle): string {
  return isCone(obstacle) ? say(lang, "cone") : translate(lang, `thing.${obstacle.type}Name`);
}

function itemsOf({ scene, lang }: State): Item[] {
  const slots = (scene.slots ?? []).map(
    (slot, i): Item => ({
      key: slot.id,
      icon: "slot",
      selection: { kind: "slot", id: slot.id },
      name: `${translate(lang, "thing.slotName")} ${i + 1}`,
      detail: slot.occupied ? translate(lang, "inspect.occupied") : translate(lang, `option.${slot.kind}`),
    }),
  );
  const counts = new Map<string, number>();
  const obstacles = (scene.obstacles ?? []).map((obstacle): Item => {
    const kind = objectName(lang, obstacle),
      n = (counts.get(kind) ?? 0) + 1;
    counts.set(kind, n);
    return {
      key: obstacle.id,
      icon: ICONS[obstacle.type],
      selection: { kind: "obstacle", id: obstacle.id },
      name: `${kind} ${n}`,
      detail: detailOf(lang, obstacle),
    };
  });
  const moving = (scene.moving ?? []).map(
    (one, i): Item => ({
      key: one.id,
      icon: "moving",
      selection: { kind: "moving", id: one.id },
      name: `${translate(lang, "thing.movingName")} ${i + 1}`,
      detail: `${number(lang, one.speed, 2)} m/s`,
    }),
  );
  const costs = (scene.costs ?? []).map(
    (area): Item => ({
      key: area.id,
      icon: "cost",
      selection: { kind: "cost", id: area.id },
      name: `${translate(lang, "thing.costName")} ×${area.weight}`,
      detail: translate(lang, "thing.cellCount", { n: cellsOf(area.runs) }),
    }),
  );
  const pose = (kind: "start" | "goal", at: Pose): Item => ({
    key: kind,
    icon: "car",
    selection: { kind },
    name: translate(lang, `inspect.${kind}`),
    detail: poseText(lang, at),
  });
  return [pose("start", scene.start), pose("goal", goalPose(scene)), ...slots, ...obstacles, ...costs, ...moving];
}

function detailOf(lang: Lang, obstacle: Obstacle): string {
  switch (obstacle.type) {
    case "cells":
      return translate(lang, "thing.cellCount", { n: cellsOf(obstacle.runs) });
    case "road":
    case "wall":
    case "polygon":
      return isCone(obstacle)
        ? conePlace(lang, obstacle.points)
        : translate(lang, "thing.corners", { n: obstacle.points.length });
    case "rectangle":
      return `${number(lang, obstacle.size[0], 2)} × ${number(lang, obstacle.size[1], 2)} m`;
    case "car":
      return poseText(lang, obstacle.pose);
  }
}

const conePlace = (lang: Lang, points: readonly (readonly number[])[]): string =>
  [0, 1].map((k) => number(lang, points.reduce((sum, point) => sum + nth(point, k), 0) / points.length, 2)).join(", ");

const counted = new WeakMap<readonly Run[], number>();

function cellsOf(runs: readonly Run[]): number {
  const known = counted.get(runs) ?? countCells(runs);
  counted.set(runs, known);
  return known;
}

function poseText(lang: Lang, { x, y, heading }: Pose): string {
  return `${number(lang, x, 2)}, ${number(lang, y, 2)} · ${number(lang, (heading * 180) / Math.PI, 0)}°`;
}

function isSame(item: NonNullable<Selection>, chosen: Selection): boolean {
  const [id] = idsOf(item);
  return id === undefined ? item.kind === chosen?.kind : idsOf(chosen).includes(id);
}

customElements.define("parkade-objects", ObjectList);
