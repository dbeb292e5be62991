/** Site plans of each kind become the same scene; damaged ones are refused in words. */
import type { Role, SitePlan } from "parkade/siteplan";
import { init, Planner, sceneGeometry, type Slot } from "parkade";
import { beforeAll, describe, expect, it } from "vitest";
import { readSitePlan } from "../../www/src/siteplan/read-site-plan";
import { MOST_BYTES, SitePlanError } from "../../www/src/siteplan/site-plan";
import { sceneFromSitePlan, suggestedRole, suggestedUnit } from "../../www/src/siteplan/site-plan-scene";
import { localProjection } from "../../www/src/siteplan/projection";
import { dxf, FILES, geojson, LOT } from "./site-plan-files";

/** Other damages than the usual ones: `PARKADE_DAMAGED_PLANS=7000 vitest run tests/js/site-plan.test.ts`. */
const FIRST_DAMAGED = Number(process.env["PARKADE_DAMAGED_PLANS"] ?? 0);

beforeAll(async () => {
  await init();
});

const rolesOf = (plan: SitePlan): Record<string, Role> =>
  Object.fromEntries(plan.layers.map(({ name }) => [name, suggestedRole(name)]));

const converted = (plan: SitePlan, unit = suggestedUnit(plan)) =>
  sceneFromSitePlan(plan, { roles: rolesOf(plan), metresPerUnit: unit });

describe("a lot", () => {
  it.each(Object.entries(FILES))("in %s becomes a scene that plans", (name, text) => {
    const plan = readSitePlan(name, text),
      { scene, counts } = converted(plan, plan.kind === "svg" ? 0.1 : undefined);
    // A column of an extract is a building.
    expect(counts).toMatchObject({ wall: 1, kerb: 1, bay: 10 });
    expect(counts.column + counts.building).toBe(1);
    sceneGeometry(scene);
    for (const slot of scene.slots!) {
      expect(slot).toMatchObject({ kind: "perpendicular" });
      expect(slot.width).toBeCloseTo(2.5, 2);
      expect(slot.length).toBeCloseTo(5, 2);
      // Bays open to the aisle.
      expect(
        [5, 11.5].some((y) => Math.abs(slot.y - y) < 0.01),
        JSON.stringify(slot),
      ).toBe(true);
      expect(Math.sin(slot.heading)).toBeCloseTo(slot.y < 8 ? -1 : 1, 3);
    }
    using planner = new Planner("hybrid", scene);
    expect(planner.plan().outcome).toBe("found");
  });

  it("is the largest of a town, in a unit that its size can have", () => {
    const square = (at: number, side: number): SitePlan["layers"][number]["lines"][number] => ({
      points: [
        [at, 0],
        [at + side, 0],
        [at + side, side],
        [at, side],
      ],
      closed: true,
    });
    const plan: SitePlan = {
      kind: "osm",
      layers: [{ name: "amenity=parking", lines: [square(0, 20), square(3000, 40)] }],
      metresPerUnit: 1,
      notes: [],
    };
    const { map } = converted(plan).scene;
    expect([map.width * map.resolution, map.height * map.resolution]).toEqual([40, 40]);
    const bay = (x: number, y: number): SitePlan["layers"][number]["lines"][number] => ({
      points: [
        [x, y],
        [x + 2.5, y],
        [x + 2.5, y + 5],
        [x, y + 5],
      ],
      closed: true,
    });
    // One bay by the first outline, and three in a place 3 km away.
    const lines = [bay(5, 5), bay(3200, 0), bay(3202.5, 0), bay(3205, 0)];
    const bays: SitePlan = { ...plan, layers: [...plan.layers, { name: "amenity=parking_space", lines }] };
    const held = converted(bays);
    expect(held.scene.map).toMatchObject({ origin: [0, 0], width: 20 / held.scene.map.resolution });
    expect([held.scene.slots!.length, held.notes]).toEqual([1, ["Bays elsewhere, which are left out: 3"]]);
    const alone = converted({ ...bays, layers: bays.layers.slice(1) });
    expect([alone.scene.slots!.length, alone.notes]).toEqual([3, ["Bays elsewhere, which are left out: 1"]]);
    // Bays in no outline of the ground are not given up for a larger outline.
    const outside: SitePlan = {
      ...bays,
      layers: [plan.layers[0]!, { name: "amenity=parking_space", lines: lines.slice(1) }],
    };
    expect(converted(outside).scene.slots!.length).toBe(3);
    // Inches, in a file that says millimetres.
    expect(suggestedUnit({ ...plan, layers: [{ name: "0", lines: [square(0, 900)] }], metresPerUnit: 0.001 })).toBe(
      0.0254,
    );
  });

  it("is measured the same whichever file it comes from", () => {
    const [first, ...others] = Object.entries(FILES).map(([name, text]) => {
      const plan = readSitePlan(name, text);
      return converted(plan, plan.kind === "svg" ? 0.1 : undefined).scene.slots!;
    });
    const places = (slots: readonly Slot[]) =>
      slots.map(({ x, y }) => [x, y]).sort((a, b) => a[0]! - b[0]! || a[1]! - b[1]!);
    for (const other of others)
      places(other).forEach(([x, y], i) => {
        expect(Math.hypot(x! - places(first!)[i]![0]!, y! - places(first!)[i]![1]!)).toBeLessThan(0.005);
      });
  });

  it("may be in metres as GeoJSON", () => {
    const plan = readSitePlan(
      "lot.geojson",
      geojson((point) => point),
    );
    expect(converted(plan).scene.slots!.map(({ width }) => width)).toEqual(Array.from({ length: 10 }, () => 2.5));
  });

  it("says what has been left out", () => {
    expect(readSitePlan("lot.dxf", dxf()).notes).toEqual(["Left out: TEXT (1)"]);
  });
});

const drawn = (layer: string, lines: readonly (readonly [number, number])[][], closed = false): SitePlan => ({
  kind: "dxf",
  layers: [{ name: layer, lines: lines.map((points) => ({ points: points.map(([x, y]) => [x, y]), closed })) }],
  metresPerUnit: 1,
  notes: [],
});

describe("bays", () => {
  const slotsOf = (plan: SitePlan): Slot[] =>
    sceneFromSitePlan(plan, { roles: { bays: "bay" }, metresPerUnit: 1 }).scene.slots!;

  it("that end aslant are as long as their shorter side, squared at the other end", () => {
    const outlines = drawn(
      "bays",
      [
        [
          [0, 0],
          [2.6, 0],
          [2.6, 9.9],
          [0, 7.2],
        ],
        [
          [2.6, 0],
          [5.2, 0],
          [5.2, 7.2],
          [2.6, 7.2],
        ],
        [
          [9, 0],
          [11.6, 0],
          [11.6, 9.9],
          [9, 3],
        ],
      ],
      true,
    );
    const slots = slotsOf(outlines);
    expect(slots.map(({ width, length }) => [width.toFixed(2), length.toFixed(2)])).toEqual([
      ["2.60", "7.20"],
      ["2.60", "7.20"],
    ]);
  });

  it("are found between painted lines, open where nothing is painted", () => {
    const comb = [
      [
        [0, 0],
        [10, 0],
      ] as [number, number][],
      ...[0, 2.5, 5, 7.5, 10].map((x): [number, number][] => [
        [x, 0],
        [x, 5],
      ]),
    ];
    const slots = slotsOf(drawn("bays", comb));
    expect(slots.map(({ kind, y }) => [kind, y])).toEqual(Array.from({ length: 4 }, () => ["perpendicular", 5]));
  });

  it("that stand back to back are told apart at the line between them", () => {
    const comb = [
      [
        [0, 5],
        [7.5, 5],
      ] as [number, number][],
      ...[0, 2.5, 5, 7.5].map((x): [number, number][] => [
        [x, 0],
        [x, 10],
      ]),
    ];
    const slots = slotsOf(drawn("bays", comb));
    expect(slots.map(({ y }) => y).sort((a, b) => a - b)).toEqual([0, 0, 0, 10, 10, 10]);
  });

  it("at an angle keep it", () => {
    const lean = 4 / Math.tan(Math.PI / 3);
    const comb = [0, 3, 6, 9].map((x): [number, number][] => [
      [x, 0],
      [x + lean, 4],
    ]);
    const slots = slotsOf(
      drawn("bays", [
        ...comb,
        [
          [0, 0],
          [9, 0],
        ],
      ]),
    );
    expect(slots).toHaveLength(3);
    for (const slot of slots) {
      expect(slot.kind).toBe("angled");
      expect(slot.angle).toBeCloseTo(Math.PI / 3, 6);
      expect(slot.width).toBeCloseTo(3 * Math.sin(Math.PI / 3), 3);
      expect(slot.y).toBe(4);
    }
  });

  it("along a kerb are parallel", () => {
    const row = Array.from({ length: 4 }, (_, i): [number, number][] => [
      [6 * i, 0],
      [6 * i + 6, 0],
      [6 * i + 6, 2.2],
      [6 * i, 2.2],
    ]);
    const kerb = {
      name: "kerb",
      lines: [{ points: [[-6, 0] as [number, number], [30, 0] as [number, number]], closed: false }],
    };
    const plan = drawn("bays", row, true);
    const { scene } = sceneFromSitePlan(
      { ...plan, layers: [...plan.layers, kerb] },
      { roles: { bays: "bay", kerb: "kerb" }, metresPerUnit: 1 },
    );
    expect(scene.slots!.map(({ kind, y }) => [kind, y])).toEqual(Array.from({ length: 4 }, () => ["parallel", 2.2]));
  });
});

describe("a file", () => {
  /** A number in [0, below) that depends on the seed alone. */
  const random = (seed: number) => {
    let state = seed * 2654435761 + 1;
    return (below: number): number => {
      state = (Math.imul(state ^ (state >>> 15), 2246822519) + 3266489917) >>> 0;
      return state % below;
    };
  };

  /** What goes wrong with files on their way. */
  const damaged = (text: string, seed: number): string => {
    const next = random(seed),
      at = 1 + next(text.length - 2);
    switch (seed % 5) {
      case 0:
        return text.slice(0, at);
      case 1:
        return text.slice(0, at) + text.slice(at + 1 + next(60));
      case 2:
        return `${text.slice(0, at)}${String.fromCharCode(1 + next(250))}${text.slice(at + 1)}`;
      case 3:
        return text.slice(0, at) + text.slice(next(text.length));
      default:
        return text.replace(/\d+/g, (number) => (next(20) === 0 ? "NaN" : number));
    }
  };

  it.each(Object.entries(FILES))("of the kind of %s that is damaged is refused in words, 500 times", (name, text) => {
    let refused = 0;
    for (let seed = FIRST_DAMAGED; seed < FIRST_DAMAGED + 500; seed++) {
      try {
        const plan = readSitePlan(name, damaged(text, seed));
        converted(plan, plan.kind === "svg" ? 0.1 : undefined);
        // A blank at the end may go.
        if (seed % 5 === 0) expect(damaged(text, seed).trimEnd()).toBe(text.trimEnd());
      } catch (error) {
        expect(error, `${name}, seed ${seed}: ${String(error)}`).toBeInstanceOf(SitePlanError);
        expect((error as SitePlanError).message).toMatch(/^[\w<$([].{8,300}$/s);
        refused++;
      }
    }
    expect(refused).toBeGreaterThan(300);
  });

  it("that is cut off is refused at its end", () => {
    expect(() => readSitePlan("lot.dxf", dxf().replace(/0\nEOF\n$/, ""))).toThrow("may be cut off");
  });

  it("names the line of a mistake", () => {
    const text = dxf().replace("17400", "wide"),
      line = text.split("\n").indexOf("wide") + 1;
    expect(() => readSitePlan("lot.dxf", text)).toThrow('group 10 must be a number, got "wide"');
    try {
      readSitePlan("lot.dxf", text);
    } catch (error) {
      expect((error as SitePlanError).line).toBe(line);
    }
  });

  /** Contents of more than 50 MB by kind, and why they are refused. */
  const LARGE: Record<string, [text: () => string, reason: string]> = {
    dxf: [
      () =>
        `0\nSECTION\n2\nENTITIES\n${`0\nLINE\n8\nA\n10\n0\n20\n0\n11\n5\n21\n${"5".padEnd(20, "0")}\n`.repeat(
          1_120_000,
        )}0\nENDSEC\n0\nEOF\n`,
      "at most 200000 entities",
    ],
    geojson: [
      () => `{"type":"LineString","coordinates":[${"[123.25,97.125],[1234567.25,97.125],\n".repeat(1_400_000)}[0,0]]}`,
      "at most 200000 points",
    ],
    svg: [() => `<svg>${'<line x1="0" y1="0" x2="10" y2="10"/>\n'.repeat(1_400_000)}</svg>`, "at most 200000 points"],
    osm: [
      () => `<osm>${'<node id="1" lat="52.5" lon="13.4" version="1"/>\n'.repeat(1_060_000)}</osm>`,
      "holds no lines",
    ],
  };

  it.each(Object.entries(LARGE))(
    "of 50 MB is read within bounds or refused: %s",
    (kind, [make, reason]) => {
      const text = make();
      expect(text.length).toBeGreaterThan(50_000_000);
      expect(() => readSitePlan(`large.${kind}`, text)).toThrow(reason);
    },
    180_000,
  );

  it("of more is refused unread", () => {
    expect(() => readSitePlan("large.dxf", new Uint8Array(MOST_BYTES + 1))).toThrow("at most 64 MB");
  });
});

describe("GeoJSON of other programs", () => {
  /** Bays of 2.5 × 5 m side by side, at a place in degrees. */
  const bays = (longitude: number, properties: object): object[] =>
    Array.from({ length: 8 }, (_, i) => {
      const [west, east] = [i, i + 1].map((k) => longitude + k * 3.68e-5) as [number, number],
        [south, north] = [52.5, 52.5 + 4.49e-5];
      const ring = [
        [west, south],
        [east, south],
        [east, north],
        [west, north],
        [west, south],
      ];
      return { type: "Feature", properties, geometry: { type: "Polygon", coordinates: [ring] } };
    });
  const planOf = (features: object[]): SitePlan =>
    readSitePlan("map.geojson", JSON.stringify({ type: "FeatureCollection", features }));

  it("says by a type what a feature is, where no tag does", () => {
    const layersOf = (properties: object): string[] => planOf(bays(5.2, properties)).layers.map(({ name }) => name);
    expect(layersOf({ feature_type: "osm_parking_space", parking: "N/A" })).toEqual(["osm_parking_space"]);
    expect(layersOf({ type: "parking_space" })).toEqual(["parking_space"]);
    expect(layersOf({ type: "multipolygon" })).toEqual(["Polygon"]);
    expect(layersOf({ amenity: "parking_space", type: "way" })).toEqual(["amenity=parking_space"]);
  });

  it("counts as degrees over a whole province", () => {
    const { scene } = converted(planOf([...bays(5.2, { type: "bay" }), ...bays(6.1, { type: "bay" })]));
    expect(scene.slots).toHaveLength(8);
    for (const { width, length } of scene.slots!) {
      expect(width).toBeCloseTo(2.5, 1);
      expect(length).toBeCloseTo(5, 1);
    }
  });
});

it("degrees become metres of the ellipsoid", () => {
  const place = localProjection([13.4, 52.5]);
  // A hundredth of a degree along the meridian and along the parallel, by the ellipsoid's radii there.
  expect(place([13.4, 52.501])[1]).toBeCloseTo(111.26, 1);
  expect(place([13.401, 52.5])[0]).toBeCloseTo(67.91, 1);
  expect(LOT.bays).toHaveLength(10);
});
