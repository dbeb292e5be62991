import type { Road } from "parkade";

export const lanesOf = (road: Road): readonly [number, number] => road.lanes ?? [1, 1];
export const laneWidthOf = (road: Road): number => road.laneWidth ?? 3.5;

/** Half the width of the whole road, metres. */
export const halfOf = (road: Road): number => ((lanesOf(road)[0] + lanesOf(road)[1]) * laneWidthOf(road)) / 2;
