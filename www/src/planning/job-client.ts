/** A worker of the complete module for one long job after another. */
import type { Run } from "../scene/cells";
import type { Scenario } from "parkade";
import { rememberPacked } from "../scene/large-scene";
import { Calls } from "./calls";
import type { Jobs, Moved } from "./job-worker";
import type { Engine } from "./engine-loader";
import { nth } from "../scene/nth";

export class Helper extends Calls<Jobs> {
  constructor({ script, module }: Engine) {
    super(new Worker(script, { type: "module", name: "parkade jobs" }), module);
  }
}

/** Runs made at once; more would hold up the page. */
const SLICE = 15_000;

/** Puts the cells that travelled apart back into their scenes. */
export async function joined({ cells }: Moved<unknown>, scenes: readonly Scenario[]): Promise<Scenario[]> {
  const whole = [...scenes];
  for (const { scene, obstacle, numbers, text } of cells) {
    const runs: Run[] = [];
    for (let i = 0; i < numbers.length; i += 3) {
      runs.push([nth(numbers, i), nth(numbers, i + 1), nth(numbers, i + 2)]);
      if (runs.length % SLICE === 0) await new Promise((done) => setTimeout(done));
    }
    rememberPacked(runs, text);
    const { obstacles = [], ...rest } = nth(whole, scene);
    whole[scene] = {
      ...rest,
      obstacles: obstacles.map((one, i) => (i === obstacle && one.type === "cells" ? { ...one, runs } : one)),
    };
  }
  return whole;
}
