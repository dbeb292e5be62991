// A test suite that plans without a page: `node --test`, in a folder where `npm install parkade` was run.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import { Planner, checkPath, init, scenario } from "parkade";

before(() => init());

/** @param {import("parkade").PlannerId} planner @param {string} id */
function planned(planner, id) {
  const prepared = new Planner(planner, scenario(id));
  try {
    return prepared.plan();
  } finally {
    prepared.free();
  }
}

for (const id of ["perpendicular", "parallel", "angled"]) {
  test(`the car gets into the slot: ${id}`, () => {
    const plan = planned("hybrid", id);
    assert.equal(plan.outcome, "found");
    assert.equal(plan.check.verdict, "ok");
    assert.ok(plan.metrics.directionChanges <= 4);
  });
}

test("the checker agrees with the plan's own check", () => {
  const plan = planned("hybrid", "perpendicular");
  assert.equal(checkPath(scenario("perpendicular"), plan.path, plan.directions).verdict, plan.check.verdict);
});

test("the same scene gives the same plan", () => {
  assert.equal(planned("hybrid", "parallel").hash, planned("hybrid", "parallel").hash);
});
