import { expect, test } from "vitest";
import { ColourTable } from "../../www/src/picture/colour-table";

const pixel = (red: number, green: number, blue: number): number =>
  ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;

/** A picture of flat fills with seams of many colours between them. */
function picture(fills: readonly number[], seams: number): Uint32Array {
  const pixels = new Uint32Array(fills.length * 1000 + seams);
  fills.forEach((fill, at) => pixels.fill(fill, 1000 * at, 1000 * (at + 1)));
  for (let k = 0; k < seams; k++) pixels[fills.length * 1000 + k] = pixel(k % 251, (7 * k) % 241, (13 * k) % 239);
  return pixels;
}

test("the fills of a picture keep their colour to the bit, however many colours its seams have", () => {
  // Greys and a tint that five and six bits a channel cannot tell apart.
  const fills = [pixel(214, 214, 210), pixel(208, 215, 208), pixel(211, 212, 213), pixel(250, 250, 248)];
  const table = new ColourTable([picture(fills, 5000), picture(fills, 3000)]);
  expect(table.colours.length).toBeLessThanOrEqual(255);
  for (const fill of fills)
    expect(table.colours[table.indexOf(fill)]).toEqual([fill & 255, (fill >> 8) & 255, (fill >> 16) & 255]);
});

test("other colours get the nearest one of the table", () => {
  const table = new ColourTable([picture([pixel(0, 0, 0), pixel(255, 255, 255)], 4000)]);
  for (let k = 0; k < 500; k++) {
    const [red, green, blue] = [(31 * k) % 256, (57 * k) % 256, (91 * k) % 256],
      away = ([r, g, b]: readonly number[]) => (r! - red) ** 2 + (g! - green) ** 2 + (b! - blue) ** 2;
    expect(away(table.colours[table.indexOf(pixel(red, green, blue))]!)).toBe(Math.min(...table.colours.map(away)));
  }
});

test("a picture of few colours has them all and no others", () => {
  const fills = [pixel(1, 2, 3), pixel(200, 100, 50)];
  expect(new ColourTable([picture(fills, 0)]).colours.sort(([a], [b]) => a - b)).toEqual([
    [1, 2, 3],
    [200, 100, 50],
  ]);
});
