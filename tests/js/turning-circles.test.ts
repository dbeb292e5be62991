import { init, vehicles } from "parkade";
import { beforeAll, expect, it } from "vitest";
import { turningCircles } from "../../www/src/scene/turning-circles";
import { vehicleOf } from "../../www/src/scene/vehicle";

beforeAll(() => init());

it("circles of the library are those that its sources state", () => {
  const stated = vehicles().filter(({ kerbRadius, wallRadius }) => kerbRadius !== null || wallRadius !== null);
  expect(stated.length).toBeGreaterThan(1);
  for (const { id, vehicle, kerbRadius, wallRadius } of stated) {
    const { kerb, wall } = turningCircles(vehicle);
    if (kerbRadius !== null) expect(Math.abs(kerb - kerbRadius), id).toBeLessThan(0.1);
    if (wallRadius !== null) expect(Math.abs(wall - wallRadius), id).toBeLessThan(0.1);
  }
});

it("the axle's circle is the planners' turning radius, and lies between the inner and the outer one", () => {
  for (const profile of ["paper", "sedan", "ship"] as const) {
    const car = vehicleOf(profile),
      { axle, kerb, wall, inner } = turningCircles(car);
    expect(axle).toBeCloseTo(car.minTurningRadius, 9);
    expect(inner).toBeLessThan(axle);
    expect(kerb).toBeGreaterThan(axle);
    expect(wall).toBeGreaterThan(kerb);
  }
});
