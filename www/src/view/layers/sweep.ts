/** The swept area: one outline, however often the car passes. */
import type { Plan } from "parkade";
import { GHOST, inMetres, inPixels, type Frame, type Shown } from "../frame";
import { sweptPath } from "../swept";
import { plannerStyle } from "../tokens";

const FILL = 0.15, EDGE = 0.75, EDGE_PX = 0.8;

interface Masked { key: string; plan: Plan }

export class SweepLayer {
  private readonly mask = document.createElement("canvas");
  private readonly edge = document.createElement("canvas");
  private masked: Masked | null = null;

  draw(frame: Frame, shown: Shown): void {
    const { plan, planner } = shown;
    if (!plan || !plan.check.drivable || plan.path.length < 6) return;
    const style = plannerStyle(frame.tokens, planner);
    this.prepare(frame, plan, style.colour);
    const { ctx } = frame;
    ctx.save();
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    const strength = shown.ghost ? GHOST : 1;
    ctx.globalAlpha = FILL * strength;
    ctx.drawImage(this.mask, 0, 0);
    ctx.globalAlpha = EDGE * strength;
    ctx.drawImage(this.edge, 0, 0);
    ctx.restore();
  }

  private prepare(frame: Frame, plan: Plan, colour: string): void {
    const { camera, width, height } = frame.view;
    const key = [camera.x, camera.y, camera.scale, width, height, frame.ratio, colour].join();
    if (this.masked?.plan === plan && this.masked.key === key) return;
    this.masked = { plan, key };
    const area = sweptPath(plan, frame.resolved.vehicle);
    const mask = contextOf(this.mask, frame), edge = contextOf(this.edge, frame);
    inMetres({ ...frame, ctx: mask });
    mask.fillStyle = colour;
    mask.fill(area);
    outline(edge, this.mask, EDGE_PX * frame.ratio);
    inPixels(frame);
  }
}

function contextOf(canvas: HTMLCanvasElement, { view, ratio }: Frame): CanvasRenderingContext2D {
  const width = Math.round(view.width * ratio), height = Math.round(view.height * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const ctx = canvas.getContext("2d");
  if (!ctx) throw new Error("This browser gives no 2D canvas.");
  ctx.setTransform(1, 0, 0, 1, 0, 0);
  ctx.globalCompositeOperation = "source-over";
  ctx.clearRect(0, 0, canvas.width, canvas.height);
  return ctx;
}

/** The mask grown by `reach` device pixels, less the mask: an even rim without the lines inside. */
function outline(ctx: CanvasRenderingContext2D, mask: HTMLCanvasElement, reach: number): void {
  for (let i = 0; i < 8; i++) ctx.drawImage(mask, Math.cos((i * Math.PI) / 4) * reach, Math.sin((i * Math.PI) / 4) * reach);
  ctx.globalCompositeOperation = "destination-out";
  ctx.drawImage(mask, 0, 0);
}
