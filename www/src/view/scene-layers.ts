/** The fixed order of the layers, and what is kept between frames. */
import { isOneGoal } from "../scene/model";
import { drawReferences } from "./car";
import { drawBorder, drawFloor } from "./layers/floor";
import { HeatLayer } from "./layers/heat";
import { drawObstacles, drawSlots } from "./layers/obstacles";
import { drawCusps, drawPath } from "./layers/path";
import { drawCollisions, drawFirstHit } from "./layers/collisions";
import { drawDrivingCar, drawStartAndGoal } from "./layers/cars";
import { hasField } from "../styles/planner-style";
import { drawHandles } from "./layers/handles";
import { drawHover } from "./layers/hover";
import { RiskLayer } from "./layers/risk";
import { SafetyLayer } from "./layers/safety";
import { drawSweep } from "./layers/sweep";
import type { TreeLayer } from "./layers/tree";
import { vast } from "./lazy-large-maps";
import { laterLayers } from "./lazy-layers";
import { isLong } from "./camera";
import { GHOST, leading, leads, type Frame, type Shown } from "./frame";

export class SceneLayers {
  private readonly heat = new HeatLayer();
  private readonly safety = new SafetyLayer();
  private readonly risk = new RiskLayer();
  private tree: TreeLayer | null = null;

  draw(frame: Frame): void {
    const { layers, scene } = frame.state;
    drawFloor(frame);
    laterLayers()?.drawLanes(frame);
    this.drawRasters(frame);
    if (scene.costs) laterLayers()?.drawCosts(frame);
    if (frame.state.bays) laterLayers()?.drawBays(frame);
    if (layers.slots) drawSlots(frame);
    drawBorder(frame);
    if (layers.obstacles) drawObstacles(frame);
    if (!isOneGoal(scene.goal)) laterLayers()?.drawGoals(frame);
    if (scene.moving?.length) laterLayers()?.drawMoving(frame);
    this.drawAnswers(frame);
    const steps = frame.state.searchSteps;
    if (leading(frame)?.planner === steps?.planner) steps?.draw(frame);
    if (frame.state.selection || frame.draft) laterLayers()?.drawSelection(frame);
    drawHandles(frame);
    if (isLong(scene)) laterLayers()?.drawLaneStrip(frame);
    if (frame.state.bays) laterLayers()?.drawBayNumbers(frame);
    if (frame.draft) laterLayers()?.drawDraft(frame);
    drawHover(frame);
  }

  /** Rasters of several planners on one canvas would hide each other: only the focused one's are drawn. */
  private drawRasters(frame: Frame): void {
    const { layers } = frame.state;
    const one = leading(frame);
    if (!one) return;
    if (layers.heat) this.heat.draw(frame, one);
    const cost = layers.cost && one.result?.layers.cost;
    if (cost) laterLayers()?.drawCost(frame, cost);
    if (layers.safety) this.safety.draw(frame, one);
    const redundant = layers.redundant && one.result?.layers.redundant;
    if (redundant) vast()?.drawClosed(frame, redundant);
    if (layers.risk) this.risk.draw(frame, one);
    const { explained, hover, transient } = frame.state;
    if (layers.risk && explained && hover && !transient && hasField(one.planner))
      laterLayers()?.drawExplained(frame, explained);
    if (layers.tree) (this.tree ??= treeLayer())?.draw(frame, one);
  }

  private drawAnswers(frame: Frame): void {
    const { layers, scene } = frame.state;
    const one = leading(frame);
    const done = !searching(frame);
    if (one && layers.sweep && done) drawSweep(frame, one);
    if (layers.ghosts) laterLayers()?.drawOthers(frame);
    if (one && !frame.overlay && layers.path && done) drawCollisions(frame, one);
    if (layers.car) drawStartAndGoal(frame);
    if (layers.difference && done) for (const shown of frame.shown) laterLayers()?.drawDifference(frame, shown);
    if (layers.path) {
      if (frame.state.smooth) laterLayers()?.drawUnsmoothed(frame);
      for (const shown of inOrder(frame)) drawPath(frame, shown, strength(frame, shown) * standing(frame, shown));
    }
    if (frame.state.preview) laterLayers()?.drawPreview(frame);
    if (layers.car) drawReferences(frame);
    if (frame.state.guest) laterLayers()?.drawGuest(frame);
    if (layers.car && one) drawDrivingCar(frame, one, strength(frame, one));
    if (one && scene.moving?.length) laterLayers()?.drawContact(frame, one);
    if (frame.overlay && layers.path && done)
      for (const shown of frame.shown) if (shown !== one) drawFirstHit(frame, shown);
    if (one && layers.path && done && one.plan && !one.plan.check.drivable) laterLayers()?.drawFailure(frame, one);
    for (const shown of frame.shown) if (shown.result?.plan?.obstruction) laterLayers()?.drawObstruction(frame, shown);
    if (one && layers.path) drawCusps(frame, one, strength(frame, one));
  }
}

const treeLayer = (): TreeLayer | null => {
  const piece = laterLayers();
  return piece && new piece.TreeLayer();
};

/** On a phone the other planners' paths stand behind the focused one's. */
const BEHIND = 0.5,
  NARROW = 640;
const standing = (frame: Frame, shown: Shown): number =>
  frame.overlay && frame.view.width <= NARROW && !leads(frame, shown) ? BEHIND : 1;

/** Before its last step a search has no answer yet: paths stand back, what follows from them is not drawn. */
const searching = ({ state: { playback } }: Frame): boolean => playback.base === "search" && playback.fraction < 1;

const strength = (frame: Frame, shown: Shown): number => (shown.ghost || searching(frame) ? GHOST : 1);

/** The focused planner is drawn last, on top. */
const inOrder = (frame: Frame): Shown[] =>
  [...frame.shown].sort((a, b) => Number(leads(frame, a)) - Number(leads(frame, b)));
