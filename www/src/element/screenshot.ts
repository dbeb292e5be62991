import { plannerName } from "../styles/planner-style";
import { statusOf } from "../texts/status";
import type { SceneView } from "../panels/scene-view";
import type { App } from "../app/app";
import { nth } from "../scene/nth";

const TITLE = 28;

/**
 * A picture of the maps as they are on screen, `scale` pixels for each of the page's, each under its planner's name and
 * answer.
 */
export async function picture(
  app: App,
  views: readonly SceneView[],
  { scale = 2, type = "image/png" } = {},
): Promise<Blob | null> {
  const shown = views.filter((view) => view.canvas && view.clientWidth > 0);
  if (shown.length === 0) return null;
  const boxes = shown.map((view) => view.getBoundingClientRect());
  const left = Math.min(...boxes.map((box) => box.left)),
    top = Math.min(...boxes.map((box) => box.top)) - TITLE;
  const right = Math.max(...boxes.map((box) => box.right)),
    bottom = Math.max(...boxes.map((box) => box.bottom));
  const ratio = scale;
  const canvas = document.createElement("canvas");
  canvas.width = Math.round((right - left) * ratio);
  canvas.height = Math.round((bottom - top) * ratio);
  const ctx = canvas.getContext("2d")!;
  ctx.scale(ratio, ratio);
  const { colour, font } = app.tokens();
  ctx.fillStyle = colour.panel;
  ctx.fillRect(0, 0, right - left, bottom - top);
  shown.forEach((view, i) => {
    const box = nth(boxes, i);
    const x = box.left - left,
      y = box.top - top;
    const drawn = view.snapshot(ratio);
    if (drawn) ctx.drawImage(drawn, x, y, box.width, box.height);
    ctx.fillStyle = colour.t1;
    ctx.font = `600 13px ${font}`;
    ctx.fillText(titleOf(app, view), x + 12, y - 9);
  });
  return new Promise((resolve) => canvas.toBlob(resolve, type));
}

function titleOf(app: App, view: SceneView): string {
  const { state } = app.store;
  return view.planners
    .map((planner) => {
      const name = plannerName(state.lang, planner);
      return view.planners.length > 1 ? name : `${name} — ${statusOf(state, planner).chip}`;
    })
    .join(" · ");
}
