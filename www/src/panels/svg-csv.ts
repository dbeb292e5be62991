/** Pictures and tables of a playground as text; the complete module, which must be there, makes them. */
import { refused } from "../i18n/refusal";
import { toCSV, toSVG, toTrajectoryCSV, type Plan } from "parkade";
import type { SceneView } from "./scene-view";
import type { State } from "../store";
import { plannedOf, played } from "../store/results";
import { makeTokens, type Tokens } from "../view/tokens";
import { nth } from "../scene/nth";
import { keysOf } from "../scene/records";

/** Each map where it stands in the element, as it is seen. */
export function svgOf(host: HTMLElement, views: readonly SceneView[], state: State, tokens: Tokens): string {
  const outer = host.getBoundingClientRect(),
    colours = coloursOf(tokens);
  const theme = state.theme === "auto" ? "auto" : tokens.dark ? "dark" : "light";
  const maps = views
    .filter((view) => view.clientWidth > 0)
    .map((view) => {
      const box = view.getBoundingClientRect(),
        plans = plansOf(state, view.planners),
        camera = view.view?.camera ?? null;
      const layers = plans.length === 1 ? (state.results[nth(plans, 0).planner]?.layers ?? {}) : {};
      const svg = toSVG(state.scene, plans, {
        width: Math.round(box.width),
        height: Math.round(box.height),
        theme,
        camera,
        colours,
        layers,
        planned: plannedIn(state, view.planners),
      });
      return svg.replace(
        "<svg ",
        `<svg x="${Math.round(box.left - outer.left)}" y="${Math.round(box.top - outer.top)}" `,
      );
    });
  const width = Math.round(outer.width),
    height = Math.round(outer.height);
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" ` +
    `width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">${maps.join("")}</svg>\n`
  );
}

/** The colours that the page has set. */
function coloursOf(tokens: Tokens): Record<string, string> {
  const usual = makeTokens(tokens.dark);
  const own = keysOf(usual.colour)
    .filter((name) => tokens.colour[name] !== usual.colour[name])
    .map((name) => [name, tokens.colour[name]]);
  const planners = tokens.planner.flatMap((colour, i) =>
    colour === usual.planner[i] ? [] : [[`planner-${i + 1}`, colour]],
  );
  return Object.fromEntries([...own, ...planners, ...(tokens.font === usual.font ? [] : [["font", tokens.font]])]);
}

export { toSVG };

/** The focused path as it is driven: its poses with the speeds and times of the drive that plays. */
export function csvOf(state: State): string {
  const { plan, drive } = played(state.results[state.focus]) ?? {};
  if (!plan) throw refused`${state.focus} has no plan.`;
  return toCSV(state.scene, plan, drive ?? undefined);
}

/** The focused drive in time; null where no car drives the path. */
export function trajectoryCsvOf(state: State): string | null {
  const drive = played(state.results[state.focus])?.drive;
  return drive ? toTrajectoryCSV(drive) : null;
}

/** The planned paths of which the shown ones were made, by planner. */
export const plannedIn = (state: State, planners: readonly string[]): Record<string, Float64Array> =>
  Object.fromEntries(
    planners.flatMap((planner) => {
      const result = state.results[planner],
        path = state.smooth ? plannedOf(played(result)?.plan ?? null, result) : null;
      return path ? [[planner, path]] : [];
    }),
  );

/** The shown paths. */
export const plansOf = (state: State, planners: readonly string[]): Plan[] =>
  planners.flatMap((planner) => played(state.results[planner])?.plan ?? []);
