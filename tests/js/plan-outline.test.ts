/** What crosses from the worker that reads a site plan to the page. */
import { expect, it } from "vitest";
import { buffersOf, outlineOf } from "../../www/src/siteplan/plan-outline";
import { readSitePlan } from "../../www/src/siteplan/read-site-plan";
import { suggestedUnit, widthOf } from "../../www/src/siteplan/site-plan-scene";
import { dxf } from "./site-plan-files";

it("a site plan crosses from a worker as rows of numbers, with all that the page draws", () => {
  const plan = readSitePlan("lot.dxf", dxf()),
    made = outlineOf(plan),
    outline = structuredClone(made, { transfer: buffersOf(made) });
  expect(outline.layers.map(({ name }) => name)).toEqual(plan.layers.map(({ name }) => name));
  for (const [i, { points, ends, closed, box }] of outline.layers.entries()) {
    const { lines } = plan.layers[i]!;
    lines.forEach((line, k) => {
      const from = k === 0 ? 0 : ends[k - 1]!;
      expect([...points.subarray(2 * from, 2 * ends[k]!)]).toEqual(line.points.flat());
      expect(closed[k] === 1).toBe(line.closed);
    });
    const across = lines.flatMap((line) => line.points.map(([x]) => x));
    expect([box.minX, box.maxX]).toEqual([Math.min(...across), Math.max(...across)]);
  }
  expect(Math.max(outline.box.maxX - outline.box.minX, outline.box.maxY - outline.box.minY)).toBe(widthOf(plan));
  expect([outline.suggestedUnit, outline.notes]).toEqual([suggestedUnit(plan), plan.notes]);
});
