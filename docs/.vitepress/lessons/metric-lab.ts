/** Makes a figure with cars live: drag a car to move it, its nose to turn it. */
import type { Pose } from "parkade";
import { WIDTH } from "./grid-drawing";
import { HEIGHT, metricDrawing, scaleOf } from "./metric-drawing";
import { advanced, initialMetric, solveMetric, type Engine, type MetricFigure, type MetricState } from "./metric-state";
import { metricControls, metricReadout } from "./metric-text";
import type { Lang } from "./words";

type End = "start" | "goal";

interface Hold {
  end: End;
  turns: boolean;
  /** From the pose to where it was taken, metres. */
  offset: [number, number];
}

/** How near to a car's nose a press turns it, metres. */
const REACH = 1.2;
const NUDGE = 0.25;
const TURN = (5 * Math.PI) / 180;

export function startMetric(
  root: HTMLElement,
  figure: MetricFigure,
  engine: Engine,
  lang: Lang,
  finish: () => void,
): void {
  new MetricLab(root, initialMetric(figure), engine, lang, finish).start();
}

class MetricLab {
  private hold: Hold | null = null;
  private touched = false;
  private waiting = false;
  private held: End;

  constructor(
    private readonly root: HTMLElement,
    private state: MetricState,
    private readonly engine: Engine,
    private readonly lang: Lang,
    private readonly finish: () => void,
  ) {
    this.held = this.ends[0]!;
  }

  private get ends(): readonly End[] {
    const { moves, shows } = this.state.figure;
    return moves ?? (shows === "body" || shows === "arc" ? ["start"] : ["start", "goal"]);
  }

  private part<T extends Element>(selector: string): T {
    return this.root.querySelector<T>(selector)!;
  }

  start(): void {
    const svg = this.part<SVGSVGElement>("svg"),
      controls = this.part<HTMLElement>(".lab-controls");
    svg.setAttribute("tabindex", "0");
    svg.addEventListener("pointerdown", (event) => this.press(event));
    svg.addEventListener("pointermove", (event) => this.drag(event));
    for (const kind of ["pointerup", "pointercancel"] as const)
      svg.addEventListener(kind, () => {
        this.hold = null;
      });
    svg.addEventListener("keydown", (event) => this.key(event));
    controls.addEventListener("click", (event) => this.click(event));
    controls.addEventListener("input", (event) => this.input(event));
    this.plan();
    this.showControls();
  }

  private showControls(): void {
    this.part(".lab-controls").innerHTML = metricControls(this.state, this.lang);
  }

  /** One plan a frame, however many moves come in it. */
  private change(): void {
    this.touched = true;
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.plan();
    });
  }

  private plan(): void {
    solveMetric(this.state, this.engine);
    this.part("svg").innerHTML = metricDrawing(this.state, this.lang);
    this.part(".lab-readout").innerHTML = metricReadout(this.state, this.lang);
    if (this.touched && this.state.figure.done(this.state)) this.finish();
  }

  private pointAt(event: PointerEvent): [number, number] {
    const box = this.part("svg").getBoundingClientRect(),
      { left, bottom, metre } = scaleOf(this.state);
    return [
      left + (((event.clientX - box.left) / box.width) * WIDTH) / metre,
      bottom + ((1 - (event.clientY - box.top) / box.height) * HEIGHT) / metre,
    ];
  }

  private press(event: PointerEvent): void {
    const [x, y] = this.pointAt(event),
      { rearToFront } = this.state.geometry!.vehicle;
    const near = this.ends
      .map((end) => {
        const pose = this.state[end],
          nose = advanced(pose, 0, rearToFront),
          middle = advanced(pose, 0, rearToFront / 2);
        const turns = Math.hypot(nose.x - x, nose.y - y) < REACH;
        return {
          end,
          turns,
          offset: [x - pose.x, y - pose.y] as [number, number],
          away: Math.hypot(middle.x - x, middle.y - y),
        };
      })
      .filter(({ turns, away }) => turns || away < rearToFront)
      .sort((a, b) => Number(b.turns) - Number(a.turns) || a.away - b.away)[0];
    if (!near || event.button !== 0) return;
    event.preventDefault();
    const svg = this.part<SVGSVGElement>("svg");
    svg.setPointerCapture(event.pointerId);
    svg.focus({ preventScroll: true });
    this.hold = near;
    this.held = near.end;
  }

  private drag(event: PointerEvent): void {
    if (!this.hold) return;
    const [x, y] = this.pointAt(event),
      { end, turns, offset } = this.hold,
      pose = this.state[end];
    this.move(
      end,
      turns
        ? { ...pose, heading: Math.atan2(y - pose.y, x - pose.x) }
        : { ...pose, x: x - offset[0], y: y - offset[1] },
    );
  }

  /** Poses stay on the map. */
  private move(end: End, { x, y, heading }: Pose): void {
    const { origin, width, height, resolution } = this.state.figure.scene.map;
    const within = (value: number, low: number, size: number): number => Math.min(low + size, Math.max(low, value));
    this.state[end] = {
      x: within(x, origin[0], width * resolution),
      y: within(y, origin[1], height * resolution),
      heading,
    };
    this.change();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const pose = this.state[this.held];
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (step) this.move(this.held, { ...pose, x: pose.x + NUDGE * step[0]!, y: pose.y + NUDGE * step[1]! });
    else if (event.key === "[" || event.key === "]")
      this.move(this.held, { ...pose, heading: pose.heading + (event.key === "[" ? TURN : -TURN) });
    else if (event.key === "Enter") this.held = this.ends[(this.ends.indexOf(this.held) + 1) % this.ends.length]!;
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private click(event: Event): void {
    const pressed = (event.target as Element).closest("button");
    if (!pressed) return;
    const { choice } = pressed.dataset;
    if (choice !== undefined) this.state.chosen = choice;
    else this.state = initialMetric(this.state.figure);
    this.touched = choice !== undefined;
    this.plan();
    this.showControls();
    if (choice !== undefined) this.part<HTMLElement>(`[data-choice="${choice}"]`).focus();
  }

  private input(event: Event): void {
    const input = event.target as HTMLInputElement;
    this.state.values[input.dataset["value"]!] = Number(input.value);
    input.parentElement!.querySelector("output")!.value = input.value;
    this.change();
  }
}
