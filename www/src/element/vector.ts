/** Pictures and tables of a playground as text; the complete module, which must be there, makes them. */
import type { Plan } from "parkade";
import type { SceneView } from "../panels/scene-view";
import { toCSV, toSVG } from "../planning/engine-complete";
import type { State } from "../store";

/** Each map where it stands in the element, drawn from the scene and its plans. */
export function svgOf(host: HTMLElement, views: readonly SceneView[], state: State): string {
  const outer = host.getBoundingClientRect(), dark = getComputedStyle(host).colorScheme === "dark";
  const maps = views.filter((view) => view.clientWidth > 0).map((view) => {
    const box = view.getBoundingClientRect();
    const svg = toSVG(state.scene, plansOf(state, view.planners), { width: Math.round(box.width), height: Math.round(box.height), theme: state.theme === "auto" ? "auto" : dark ? "dark" : "light" });
    return svg.replace("<svg ", `<svg x="${Math.round(box.left - outer.left)}" y="${Math.round(box.top - outer.top)}" `);
  });
  const width = Math.round(outer.width), height = Math.round(outer.height);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">${maps.join("")}</svg>\n`;
}

export function csvOf(state: State): string {
  const [plan] = plansOf(state, [state.focus]);
  if (!plan) throw new Error(`${state.focus} has no plan.`);
  return toCSV(state.scene, plan);
}

const plansOf = (state: State, planners: readonly string[]): Plan[] => planners.flatMap((planner) => state.results[planner]?.plan ?? []);
