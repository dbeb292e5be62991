/** A map and a scene that tests of the scene's model share. */
import type { MapFrame } from "parkade";
import * as model from "../../www/src/scene/model";
import type { Scenario } from "../../www/src/scene/scenario";
import { slotRow } from "../../www/src/scene/slots";

export const frame: MapFrame = { origin: [-10, -5], width: 80, height: 60, resolution: 0.25 };

/** One thing of each kind. */
export const scene: Scenario = model.ensureIds({
  version: 1,
  name: "yard",
  map: {
    origin: [-10, -5],
    width: 80,
    height: 60,
    resolution: 0.25,
    boundary: [
      [-10, -5],
      [10, -5],
      [10, 10],
      [-10, 10],
    ],
  },
  obstacles: [
    {
      type: "polygon",
      id: "planter",
      points: [
        [1.1, 6.6],
        [4.3, 5.9],
        [5.8, 3.7],
      ],
    },
    {
      type: "wall",
      points: [
        [-9, 9],
        [-3.25, 8.5],
      ],
      thickness: 0.2,
    },
    { type: "rectangle", center: [6, 8], size: [4.4, 2], heading: Math.PI / 9 },
    { type: "car", pose: { x: -8, y: 0.5, heading: Math.PI / 2 }, vehicle: "sedan" },
    {
      type: "cells",
      runs: [
        [40, 50, 6],
        [39, 51, 8],
      ],
    },
  ],
  slots: slotRow({ kind: "angled", width: 2.8, length: 5.4, angle: Math.PI / 4, lean: "right" }, [-9, -4], [9, -4]),
  vehicle: "paper",
  start: { x: -4, y: 3, heading: 0 },
  goal: { slot: "slot-2", entry: "head-in" },
});
