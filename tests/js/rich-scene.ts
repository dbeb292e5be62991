/** A scene with everything that a scene may have. */
export const RICH = {
  version: 1,
  name: "Everything",
  map: {
    origin: [0, 0],
    width: 60,
    height: 40,
    resolution: 0.5,
    boundary: [
      [0, 0],
      [30, 0],
      [30, 20],
      [0, 20],
    ],
  },
  vehicle: { wheelbase: 2.7, width: 1.9, rearToFront: 3.6, rearToBack: 1, maxSteer: 0.6, maxSteerRate: 0.5 },
  start: { x: 4, y: 10, heading: 0 },
  goal: { slot: "bay", entry: "head-in" },
  obstacles: [
    { type: "rectangle", id: "box", center: [10, 4], size: [1, 1], heading: 0.1 },
    {
      type: "polygon",
      points: [
        [14, 3],
        [15, 3],
        [15, 4],
      ],
    },
    {
      type: "wall",
      points: [
        [1, 1],
        [2, 1],
      ],
      thickness: 0.1,
    },
    { type: "car", pose: { x: 24, y: 3, heading: 0 } },
    { type: "cells", runs: [[2, 2, 3]] },
    {
      type: "road",
      points: [
        [0, 10],
        [30, 10],
      ],
      radius: 20,
      lanes: [1, 1],
      laneWidth: 3.5,
      speed: 8,
      kerbs: true,
    },
  ],
  slots: [
    {
      id: "bay",
      kind: "angled",
      x: 20,
      y: 16,
      heading: 1.5,
      width: 3,
      length: 3,
      angle: 1,
      lean: "left",
      occupied: false,
    },
  ],
  costs: [{ id: "mud", runs: [[5, 5, 2]], weight: 2 }],
  moving: [
    {
      id: "bus",
      points: [
        [28, 18],
        [29, 18],
      ],
      size: [1, 1],
      speed: 1,
      start: 2,
    },
  ],
  lanes: [{ id: "lane", start: { x: 1, y: 10, heading: 0 }, pieces: [{ length: 5, curvature: 0.1 }], width: 3.5 }],
  speedLimits: [
    {
      points: [
        [1, 18],
        [3, 18],
        [3, 19],
      ],
      speed: 1,
    },
  ],
};
