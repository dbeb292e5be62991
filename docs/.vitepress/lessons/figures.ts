/** The figures of the lessons: what each shows, and when its task is done. */
import { flood } from "./figures-flood";
import { both, neighbours, risk, rounding } from "./figures-grid";
import { body, hybrid, road } from "./figures-metric";
import type { GridFigure } from "./grid-state";
import type { MetricFigure } from "./metric-state";

export type Figure = GridFigure | MetricFigure;

export const FIGURES: Readonly<Record<string, Figure>> = {
  ...flood,
  ...neighbours,
  ...both,
  ...risk,
  ...rounding,
  ...body,
  ...hybrid,
  ...road,
};

export function figureOf(id: string): Figure {
  const figure = FIGURES[id];
  if (!figure) throw new Error(`docs/.vitepress/lessons has no figure "${id}"`);
  return figure;
}
