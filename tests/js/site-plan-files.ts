/** One parking lot as files of each kind: two rows of five bays, walls around, a column, a kerb. */

type Point = readonly [number, number];

/** Metres. Bays of 2.5 × 5 m to both sides of an aisle of 6.5 m. */
export const LOT = {
  walls: [
    [0, 0],
    [20, 0],
    [20, 16.5],
    [0, 16.5],
    [0, 0],
  ] as Point[],
  bays: Array.from({ length: 10 }, (_, i): Point[] => {
    const x = 4 + 2.5 * (i % 5),
      y = i < 5 ? 0 : 11.5;
    return [
      [x, y],
      [x + 2.5, y],
      [x + 2.5, y + 5],
      [x, y + 5],
    ];
  }),
  column: [
    [17, 5.5],
    [17.4, 5.5],
    [17.4, 5.9],
    [17, 5.9],
  ] as Point[],
  kerb: [
    [1, 4],
    [1, 2],
    [3, 2],
  ] as Point[],
};

const pairs = (...groups: (readonly [number, string | number])[]): string =>
  groups.map(([code, value]) => `${code}\n${value}\n`).join("");

const polyline = (layer: string, points: readonly Point[], closed: boolean, unit: number): string =>
  pairs(
    [0, "LWPOLYLINE"],
    [8, layer],
    [90, points.length],
    [70, closed ? 1 : 0],
    ...points.flatMap(([x, y]) => [[10, x * unit] as const, [20, y * unit] as const]),
  );

/** In millimetres; the bays of the lower row as outlines, those of the upper one as a block placed five times. */
export function dxf(): string {
  const block = pairs([0, "BLOCK"], [8, "0"], [2, "STALL"], [10, 0], [20, 0]);
  const stall: Point[] = [
    [0, 0],
    [2.5, 0],
    [2.5, 5],
    [0, 5],
  ];
  return [
    pairs([0, "SECTION"], [2, "HEADER"], [9, "$INSUNITS"], [70, 4], [0, "ENDSEC"]),
    pairs([0, "SECTION"], [2, "BLOCKS"]),
    block,
    polyline("0", stall, true, 1000),
    pairs([0, "ENDBLK"], [0, "ENDSEC"]),
    pairs([0, "SECTION"], [2, "ENTITIES"]),
    ...LOT.walls.slice(1).map(([x, y], i) => {
      const [px, py] = LOT.walls[i]!;
      return pairs([0, "LINE"], [8, "WALLS"], [10, px * 1000], [20, py * 1000], [11, x * 1000], [21, y * 1000]);
    }),
    ...LOT.bays.slice(0, 5).map((bay) => polyline("BAYS", bay, true, 1000)),
    ...LOT.bays
      .slice(5)
      .map(([[x, y] = [0, 0]]) => pairs([0, "INSERT"], [8, "BAYS"], [2, "STALL"], [10, x * 1000], [20, y * 1000])),
    polyline("COLUMNS", LOT.column, true, 1000),
    polyline("KERB", LOT.kerb, false, 1000),
    pairs([0, "TEXT"], [8, "NOTES"], [10, 0], [20, 0], [1, "Level 1"]),
    pairs([0, "ENDSEC"], [0, "EOF"]),
  ].join("");
}

/** Ten units a metre, y down, the columns' group turned and moved. */
export function svg(): string {
  const at = ([x, y]: Point): string => `${x * 10},${(16.5 - y) * 10}`;
  const [[cx, cy] = [0, 0]] = LOT.column;
  return (
    `<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" viewBox="0 0 ` +
    `200 165">
  <g inkscape:label="Walls"><polyline points="${LOT.walls.map(at).join(" ")}"/></g>
  <g inkscape:label="Bays">${LOT.bays.map((bay) => `<polygon points="${bay.map(at).join(" ")}"/>`).join("\n    ")}</g>
  <g inkscape:label="Columns" transform="translate(${cx * 10} ${(16.5 - cy) * 10}) rotate(-90)"><rect width="4" ` +
    `height="4"/></g>
  <g id="kerb"><path d="M${at(LOT.kerb[0]!)} V${(16.5 - 2) * 10} h20"/></g>
  <text x="3" y="4">Level 1</text>
</svg>
`
  );
}

/** The place of a point in metres, degrees east and north of a corner in Berlin; good to a millimetre over a lot. */
const degreesOf = ([x, y]: Point): Point => {
  const latitude = 52.5,
    sin2 = Math.sin((latitude * Math.PI) / 180) ** 2,
    squared = 0.00669437999014,
    normal = 6_378_137 / Math.sqrt(1 - squared * sin2),
    meridian = (normal * (1 - squared)) / (1 - squared * sin2);
  const north = (y / meridian) * (180 / Math.PI),
    east = (x / (normal * Math.cos((latitude * Math.PI) / 180))) * (180 / Math.PI);
  return [13.4 + east, latitude + north];
};

export function geojson(place: (point: Point) => Point = degreesOf): string {
  const feature = (layer: string, type: string, coordinates: unknown) => ({
    type: "Feature",
    properties: { layer },
    geometry: { type, coordinates },
  });
  const ring = (points: readonly Point[]): Point[] => [...points, points[0]!].map(place);
  return JSON.stringify({
    type: "FeatureCollection",
    features: [
      feature("walls", "LineString", LOT.walls.map(place)),
      ...LOT.bays.map((bay) => feature("bays", "Polygon", [ring(bay)])),
      feature("columns", "MultiPolygon", [[ring(LOT.column)]]),
      feature("kerb", "LineString", LOT.kerb.map(place)),
      { type: "Feature", properties: {}, geometry: null },
    ],
  });
}

export function osm(): string {
  let id = 0;
  const nodes: string[] = [],
    ways: string[] = [];
  const way = (points: readonly Point[], tags: Record<string, string>): void => {
    const refs = points.map((point) => {
      const [lon, lat] = degreesOf(point);
      nodes.push(`  <node id="${++id}" lat="${lat}" lon="${lon}"/>`);
      return id;
    });
    const closed = tags["barrier"] ? refs : [...refs, refs[0]!];
    const described = Object.entries(tags).map(([key, value]) => `<tag k="${key}" v="${value}"/>`);
    ways.push(`  <way id="${++id}">${closed.map((ref) => `<nd ref="${ref}"/>`).join("")}${described.join("")}</way>`);
  };
  way(LOT.walls, { barrier: "wall" });
  for (const bay of LOT.bays) way(bay, { amenity: "parking_space" });
  way(LOT.column, { building: "column" });
  way(LOT.kerb, { barrier: "kerb" });
  way(
    [
      [-5, -5],
      [30, -5],
    ],
    { highway: "service" },
  );
  return (
    `<?xml version="1.0" encoding="UTF-8"?>\n<osm ` +
    `version="0.6">\n${nodes.join("\n")}\n${ways.join("\n")}\n</osm>\n`
  );
}

export const FILES: Record<string, string> = {
  "lot.dxf": dxf(),
  "lot.svg": svg(),
  "lot.geojson": geojson(),
  "lot.osm": osm(),
};
