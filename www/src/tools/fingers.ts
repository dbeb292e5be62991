/** Fingers on a canvas: two move the view, three take back, one that rests asks for the menu. */
import { distance, type Point } from "../scene/geometry";
import type { Camera } from "../store";
import type { View } from "../view/camera";
import { Pinch } from "./pinch";

const TAP_MS = 400;
const TAP_PX = 24;
const LONG_MS = 500;
const LONG_PX = 8;

export class Fingers {
  private readonly down = new Map<number, Point>();
  private pinch: Pinch | null = null;
  /** Three fingers that may be a tap. */
  private tap: { since: number; from: Map<number, Point> } | null = null;
  private long: { pointer: number; from: Point; timer: ReturnType<typeof setTimeout> } | null = null;

  get pinching(): boolean {
    return this.pinch !== null;
  }

  /** How many are down now. */
  press(pointer: number, at: Point, now: number): number {
    this.down.set(pointer, at);
    if (this.down.size === 2) this.pinch = new Pinch(...([...this.down.values()] as [Point, Point]));
    this.tap = this.down.size === 3 ? { since: now, from: new Map(this.down) } : null;
    if (this.down.size > 1) this.forgetLong();
    return this.down.size;
  }

  /** Calls when a finger rests where it was put. */
  whenLong(pointer: number, from: Point, run: () => void): void {
    this.forgetLong();
    this.long = { pointer, from, timer: setTimeout(run, LONG_MS) };
  }

  /** True if a finger has stayed where it was put, not for long. */
  rests(pointer: number): boolean {
    return this.long?.pointer === pointer;
  }

  move(pointer: number, at: Point): void {
    if (this.down.has(pointer)) this.down.set(pointer, at);
    if (this.long?.pointer === pointer && distance(this.long.from, at) > LONG_PX) this.forgetLong();
    const from = this.tap?.from.get(pointer);
    if (from && distance(from, at) > TAP_PX) this.tap = null;
  }

  /** The camera after two fingers moved; null where they do not move it. */
  moved(view: View, least: number): Camera | null {
    const [a, b] = [...this.down.values()];
    return a && b && this.pinch ? this.pinch.move(view, a, b, least) : null;
  }

  /** True if the last of three fingers of a tap has left. */
  release(pointer: number, now: number): boolean {
    this.down.delete(pointer);
    if (this.long?.pointer === pointer) this.forgetLong();
    if (this.down.size < 2) this.pinch = null;
    if (this.down.size > 0 || !this.tap) return false;
    const tapped = now - this.tap.since < TAP_MS;
    this.tap = null;
    return tapped;
  }

  private forgetLong(): void {
    clearTimeout(this.long?.timer);
    this.long = null;
  }
}
