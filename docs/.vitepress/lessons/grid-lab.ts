/** Makes a grid figure live: the reader draws, and the package plans. */
import { viewOf, drawingOf, WIDTH } from "./grid-drawing";
import { mapOf } from "./grid-map";
import { initialState, solve, type Engine, type GridFigure, type GridState } from "./grid-state";
import { controlsOf, readoutOf } from "./grid-text";
import type { Lang } from "./words";

interface Parts {
  svg: SVGSVGElement;
  controls: HTMLElement;
  readout: HTMLElement;
}

type Hold = "wall" | "erase" | "start" | "goal";

export function startGrid(root: HTMLElement, figure: GridFigure, engine: Engine, lang: Lang, finish: () => void): void {
  const find = <T extends Element>(selector: string): T => root.querySelector<T>(selector)!;
  const parts: Parts = { svg: find("svg"), controls: find(".lab-controls"), readout: find(".lab-readout") };
  const lab = new GridLab(parts, initialState(figure), engine, lang, finish);
  lab.start();
}

class GridLab {
  private hold: Hold | null = null;
  private moved = false;
  private cursor: number | null = null;
  /** True once the reader has changed anything: the first picture is no answer. */
  private touched = false;
  private readonly side: number;

  constructor(
    private readonly parts: Parts,
    private state: GridState,
    private readonly engine: Engine,
    private readonly lang: Lang,
    private readonly finish: () => void,
  ) {
    this.side = viewOf(state.map).side;
  }

  start(): void {
    const { svg, controls } = this.parts;
    svg.setAttribute("tabindex", "0");
    svg.addEventListener("pointerdown", (event) => this.press(event));
    svg.addEventListener("pointermove", (event) => this.drag(event));
    for (const kind of ["pointerup", "pointercancel"] as const) svg.addEventListener(kind, () => this.release());
    svg.addEventListener("keydown", (event) => this.key(event));
    svg.addEventListener("blur", () => {
      this.cursor = null;
      this.draw();
    });
    controls.addEventListener("click", (event) => this.click(event));
    controls.addEventListener("input", (event) => this.input(event));
    this.plan();
    this.showControls();
  }

  private showControls(): void {
    this.parts.controls.innerHTML = controlsOf(this.state, this.lang);
  }

  private plan(): void {
    solve(this.state, this.engine);
    this.draw();
    if (this.touched && this.state.figure.done(this.state)) this.finish();
  }

  private draw(): void {
    this.parts.svg.innerHTML = drawingOf(this.state, this.cursor);
    this.parts.readout.innerHTML = readoutOf(this.state, this.lang);
  }

  private cellAt(event: PointerEvent): number | null {
    const box = this.parts.svg.getBoundingClientRect(),
      scale = WIDTH / box.width / this.side;
    const x = Math.floor((event.clientX - box.left) * scale),
      y = Math.floor((event.clientY - box.top) * scale),
      { width, height } = this.state.map;
    return x >= 0 && y >= 0 && x < width && y < height ? y * width + x : null;
  }

  private press(event: PointerEvent): void {
    const cell = this.cellAt(event);
    if (cell === null || event.button !== 0) return;
    this.parts.svg.setPointerCapture(event.pointerId);
    const { map } = this.state;
    this.hold = cell === map.start ? "start" : cell === map.goal ? "goal" : map.walls[cell] ? "erase" : "wall";
    this.moved = false;
    this.last = cell;
    event.preventDefault();
    this.parts.svg.focus({ preventScroll: true });
  }

  private last = 0;

  private drag(event: PointerEvent): void {
    const cell = this.cellAt(event);
    if (this.hold === null || cell === null || cell === this.last) return;
    if (!this.moved && (this.hold === "wall" || this.hold === "erase")) this.apply(this.last, this.hold);
    this.moved = true;
    for (const one of between(this.last, cell, this.state.map.width)) this.apply(one, this.hold);
    this.last = cell;
    this.touched = true;
    this.plan();
  }

  private release(): void {
    if (this.hold !== null && !this.moved) this.pick(this.last);
    this.hold = null;
  }

  private apply(cell: number, hold: Hold): void {
    const { map } = this.state,
      isEnd = cell === map.start || cell === map.goal;
    if (isEnd || (map.walls[cell] && (hold === "start" || hold === "goal"))) return;
    if (hold === "start" || hold === "goal") map[hold] = cell;
    else map.walls[cell] = hold === "wall";
  }

  private pick(cell: number): void {
    this.state.picked = cell;
    this.touched = true;
    this.plan();
  }

  private key(event: KeyboardEvent): void {
    const { map } = this.state,
      cell = this.cursor ?? map.start;
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (step) {
      const x = Math.min(map.width - 1, Math.max(0, (cell % map.width) + step[0]!)),
        y = Math.min(map.height - 1, Math.max(0, Math.floor(cell / map.width) + step[1]!));
      this.cursor = y * map.width + x;
      this.draw();
    } else if (event.key === "Enter") this.pick(cell);
    else if (event.key === " ") this.edit(cell, map.walls[cell] ? "erase" : "wall");
    else if (event.key === "s" || event.key === "S") this.edit(cell, "start");
    else if (event.key === "g" || event.key === "G") this.edit(cell, "goal");
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private edit(cell: number, hold: Hold): void {
    this.cursor = cell;
    this.apply(cell, hold);
    this.touched = true;
    this.plan();
  }

  private click(event: Event): void {
    const pressed = (event.target as Element).closest("button");
    if (!pressed) return;
    const { choice, stage } = pressed.dataset;
    if (choice !== undefined) this.state.chosen = choice;
    else if (stage !== undefined) this.state.stage = stage as GridState["stage"];
    else this.state = { ...initialState(this.state.figure), map: mapOf(this.state.figure.map) };
    this.touched = choice !== undefined || stage !== undefined;
    for (const name of ["choice", "stage"] as const)
      for (const one of this.parts.controls.querySelectorAll<HTMLElement>(`[data-${name}]`))
        one.setAttribute(
          "aria-pressed",
          String(one.dataset[name] === (name === "choice" ? this.state.chosen : this.state.stage)),
        );
    if (!this.touched) this.showControls();
    this.plan();
  }

  private input(event: Event): void {
    const input = event.target as HTMLInputElement;
    if (input.dataset["share"] !== undefined) this.state.share = Number(input.value);
    else {
      this.state.value = Number(input.value);
      input.parentElement!.querySelector("output")!.value = input.value;
    }
    this.touched = true;
    this.plan();
  }
}

/** The cells on the line from one to another, the last one with them. */
function* between(from: number, to: number, width: number): Generator<number> {
  const [x0, y0, x1, y1] = [from % width, Math.floor(from / width), to % width, Math.floor(to / width)] as const,
    steps = Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0));
  for (let i = 1; i <= steps; i++)
    yield Math.round(y0 + ((y1 - y0) * i) / steps) * width + Math.round(x0 + ((x1 - x0) * i) / steps);
}
