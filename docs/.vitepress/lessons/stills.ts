/** A figure as it stands in the page before any script has run. */
import type { Figure } from "./figures";
import { drawingOf, viewOf, WIDTH } from "./grid-drawing";
import { initialState, solve, type GridFigure } from "./grid-state";
import { controlsOf, describedBy, escaped, readoutOf } from "./grid-text";
import { HEIGHT, metricDrawing } from "./metric-drawing";
import { initialMetric, solveMetric, type Engine, type MetricFigure } from "./metric-state";
import { metricControls, metricReadout } from "./metric-text";
import { word, type Lang } from "./words";

interface Still {
  height: number;
  label: string;
  drawing: string;
  controls: string;
  readout: string;
}

export function stillOf(figure: Figure, engine: Engine, lang: Lang): string {
  const { height, label, drawing, controls, readout } =
    figure.kind === "grid" ? grid(figure, engine, lang) : metric(figure, engine, lang);
  return (
    `<svg class="lab-stage" viewBox="0 ` +
    `0 ${WIDTH} ${height}" role="application" ` +
    `aria-label="${escaped(label)}">${drawing}</svg><div ` +
    `class="lab-controls">${controls}</div><p class="lab-readout">${readout}</p>`
  );
}

function grid(figure: GridFigure, engine: Engine, lang: Lang): Still {
  const state = initialState(figure);
  solve(state, engine);
  return {
    height: Math.round(viewOf(state.map).height),
    label: describedBy(state, lang),
    drawing: drawingOf(state),
    controls: controlsOf(state, lang),
    readout: readoutOf(state, lang),
  };
}

function metric(figure: MetricFigure, engine: Engine, lang: Lang): Still {
  const state = initialMetric(figure);
  solveMetric(state, engine);
  return {
    height: HEIGHT,
    label: word("cars", lang),
    drawing: metricDrawing(state, lang),
    controls: metricControls(state, lang),
    readout: metricReadout(state, lang),
  };
}
