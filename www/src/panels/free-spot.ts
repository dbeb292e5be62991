/** A place beside a thing that covers nothing else. */
import { resolve } from "../scene/model";
import { boxOf, type Box } from "../scene/geometry";
import { footprint } from "../scene/vehicle";
import type { State } from "../store";
import { worldToScreen } from "../view/camera";
import { gripOf } from "../view/pose-handle";
import type { SceneView } from "./scene-view";

type Point = [x: number, y: number];
export interface Spot {
  x: number;
  y: number /** The points of its edge and of the thing that face each other. */;
  tip: Point;
  to: Point;
}

/** From the edges, and between a thing and what speaks of it: a row of controls or text may be between. CSS pixels. */
const EDGE = 8,
  GAPS = [10, 46, 80];
/** How far along a side the box may stand from the middle, as parts of its own length. */
const SHIFTS = [0, -0.25, 0.25, -0.42, 0.42];

const rounded = ([x, y]: Point): Point => [Math.round(x), Math.round(y)];

/**
 * The first place at a side of `anchor` where a box of this size is inside `bounds` and meets none of `taken`; null
 * where there is none.
 */
export function freeSpot(
  anchor: Box,
  { offsetWidth: width, offsetHeight: height }: { offsetWidth: number; offsetHeight: number },
  bounds: { width: number; height: number },
  taken: readonly Box[],
): Spot | null {
  const middleX = (anchor.minX + anchor.maxX) / 2,
    middleY = (anchor.minY + anchor.maxY) / 2;
  for (const [gap, shift] of GAPS.flatMap((one) => SHIFTS.map((other) => [one, other] as const))) {
    const x = middleX - width * (0.5 + shift),
      y = middleY - height * (0.5 + shift);
    const spots: Spot[] = [
      { x: anchor.maxX + gap, y, tip: [anchor.maxX + gap, middleY], to: [anchor.maxX, middleY] },
      { x: anchor.minX - gap - width, y, tip: [anchor.minX - gap, middleY], to: [anchor.minX, middleY] },
      { x, y: anchor.minY - gap - height, tip: [middleX, anchor.minY - gap], to: [middleX, anchor.minY] },
      { x, y: anchor.maxY + gap, tip: [middleX, anchor.maxY + gap], to: [middleX, anchor.maxY] },
    ];
    const free = spots.find((spot) => {
      const inside =
        spot.x >= EDGE &&
        spot.y >= EDGE &&
        spot.x + width <= bounds.width - EDGE &&
        spot.y + height <= bounds.height - EDGE;
      return (
        inside &&
        !taken.some(
          (box) => box.minX < spot.x + width && box.maxX > spot.x && box.minY < spot.y + height && box.maxY > spot.y,
        )
      );
    });
    if (free) return { x: Math.round(free.x), y: Math.round(free.y), tip: rounded(free.tip), to: rounded(free.to) };
  }
  return null;
}

/** Half of the grip's box, CSS pixels. */
const GRIP = 14;
const CONTROLS = "button, input, select, textarea, a, summary";

export interface GoalOnMap {
  grip: Box /** At the start and at the goal. */;
  cars: readonly Box[];
}

/** The grip of the goal car on the map in front, in the window's pixels; null where that map does not show it. */
export function goalOnMap(host: HTMLElement, { scene, geometry }: State): GoalOnMap | null {
  const stage = host.shadowRoot?.querySelector("parkade-stage")?.shadowRoot,
    inside = (root?: ParentNode | null): SceneView | null =>
      root?.querySelector<SceneView>("parkade-scene-view") ?? null;
  const map = inside(stage) ?? inside(stage?.querySelector("parkade-panel[active]")?.shadowRoot),
    view = map?.view;
  if (!map || !view || !geometry) return null;
  const { left, top, width, height } = map.getBoundingClientRect(),
    { start, goal, vehicle } = resolve(scene);
  const [x, y] = worldToScreen(view, ...gripOf(goal, vehicle));
  if (x < 0 || y < 0 || x > width || y > height) return null;
  const cars = [start, goal].map((pose) =>
    boxOf(
      footprint(pose, vehicle).map(([wx, wy]) => {
        const [px, py] = worldToScreen(view, wx, wy);
        return [px + left, py + top];
      }),
    ),
  );
  return { grip: { minX: left + x - GRIP, maxX: left + x + GRIP, minY: top + y - GRIP, maxY: top + y + GRIP }, cars };
}

export function boxAround(element: Element): Box {
  const { left, top, right, bottom } = element.getBoundingClientRect();
  return { minX: left, maxX: right, minY: top, maxY: bottom };
}

export const moved = ({ minX, maxX, minY, maxY }: Box, { left, top }: DOMRect): Box => ({
  minX: minX - left,
  maxX: maxX - left,
  minY: minY - top,
  maxY: maxY - top,
});

/** Every control and every text below `root`, but for some elements'. */
export function* boxesOf(root: ParentNode, except: string): Generator<Box> {
  for (const element of root.querySelectorAll("*")) {
    if (element.matches(`.visually-hidden, ${except}`)) continue;
    if (element.shadowRoot) yield* boxesOf(element.shadowRoot, except);
    const speaks =
      element.matches(CONTROLS) ||
      [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim());
    if (speaks && element.checkVisibility({ visibilityProperty: true })) yield boxAround(element);
  }
}
