/** The fixed order of the layers, and what is kept between frames. */
import { drawReferences } from "./car";
import { drawBorder, drawFloor } from "./layers/floor";
import { HeatLayer } from "./layers/heat";
import { drawObstacles, drawSlots } from "./layers/obstacles";
import { drawCusps, drawPath } from "./layers/path";
import { drawCollisions, drawFirstHit } from "./layers/collisions";
import { drawDrivingCar, drawStartAndGoal } from "./layers/cars";
import { drawDraft } from "./layers/draft";
import { drawHandles, drawSelection } from "./layers/handles";
import { drawHover } from "./layers/hover";
import { RiskLayer } from "./layers/risk";
import { SafetyLayer } from "./layers/safety";
import { drawSweep } from "./layers/sweep";
import { TreeLayer } from "./layers/tree";
import { drawOthers } from "./layers/ghosts";
import { GHOST, leading, leads, type Frame, type Shown } from "./frame";

export class SceneLayers {
  private readonly heat = new HeatLayer();
  private readonly safety = new SafetyLayer();
  private readonly risk = new RiskLayer();
  private readonly tree = new TreeLayer();

  draw(frame: Frame): void {
    const { layers } = frame.state;
    drawFloor(frame);
    this.drawRasters(frame);
    if (layers.slots) drawSlots(frame);
    drawBorder(frame);
    if (layers.obstacles) drawObstacles(frame);
    this.drawAnswers(frame);
    drawSelection(frame);
    drawHandles(frame);
    drawDraft(frame);
    drawHover(frame);
  }

  /** Rasters of several planners on one canvas would hide each other: only the focused one's are drawn. */
  private drawRasters(frame: Frame): void {
    const { layers } = frame.state;
    const one = leading(frame);
    if (!one) return;
    if (layers.heat) this.heat.draw(frame, one);
    if (layers.safety) this.safety.draw(frame, one);
    if (layers.risk) this.risk.draw(frame, one);
    if (layers.tree) this.tree.draw(frame, one);
  }

  private drawAnswers(frame: Frame): void {
    const { layers } = frame.state;
    const one = leading(frame);
    if (one && layers.sweep) drawSweep(frame, one);
    if (layers.ghosts) drawOthers(frame);
    if (one && !frame.overlay && layers.path) drawCollisions(frame, one);
    if (layers.car) drawStartAndGoal(frame);
    for (const shown of inOrder(frame)) if (layers.path) drawPath(frame, shown, strength(shown) * (crowded(frame) && !leads(frame, shown) ? BEHIND : 1));
    if (layers.car) drawReferences(frame);
    if (layers.car) for (const shown of inOrder(frame)) drawDrivingCar(frame, shown, strength(shown));
    if (frame.overlay && layers.path) for (const shown of frame.shown) drawFirstHit(frame, shown);
    for (const shown of inOrder(frame)) if (layers.path && leads(frame, shown)) drawCusps(frame, shown, strength(shown));
  }
}

/** On a phone the other planners' paths stand behind the focused one's. */
const BEHIND = 0.5, NARROW = 640;
const crowded = ({ overlay, view }: Frame): boolean => overlay && view.width <= NARROW;

const strength = (shown: Shown): number => (shown.ghost ? GHOST : 1);

/** The focused planner is drawn last, on top. */
const inOrder = (frame: Frame): Shown[] => [...frame.shown].sort((a, b) => Number(leads(frame, a)) - Number(leads(frame, b)));
