/** The tools that draw and the keys that edit; the first picture does without them. */
import type { ToolId } from "../store";
import { BorderTool } from "./border";
import { BrushTool, CostTool, EraserTool } from "./brush";
import { CarTool } from "./car";
import { nudge } from "./edit-keys";
import { MovingTool, PolygonTool, RoadTool, WallTool } from "./line";
import { PlaceTool } from "./place";
import { RectangleTool } from "./rectangle";
import type { SelectTool } from "./select";
import { SlotTool } from "./slot";
import type { Tool } from "./tool";

export { watchGoalSlot } from "./slot-fit";

export interface Drawing {
  tools: Record<Exclude<ToolId, "hand">, Tool>;
  /** Of the right button. */
  eraser: Tool;
  /** By press, drag, release while S or T is called for. */
  place: { start: PlaceTool; goal: PlaceTool };
  nudge: typeof nudge;
}

export const makeDrawing = (select: SelectTool): Drawing => ({
  tools: {
    select: new BorderTool(select),
    brush: new BrushTool(),
    cost: new CostTool(),
    wall: new WallTool(),
    rectangle: new RectangleTool(),
    polygon: new PolygonTool(),
    car: new CarTool(),
    slot: new SlotTool(),
    moving: new MovingTool(),
    road: new RoadTool(),
    eraser: new EraserTool(),
  },
  eraser: new EraserTool(),
  place: { start: new PlaceTool("start"), goal: new PlaceTool("goal") },
  nudge,
});
