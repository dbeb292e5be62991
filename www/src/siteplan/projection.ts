/** Degrees of WGS 84 on the plane that touches the ellipsoid in the plan's middle: metres east and north. */
import { boxOf, radians, type Point } from "../scene/geometry";
import { nth } from "../scene/nth";

const EQUATOR = 6_378_137,
  FLATTENING = 1 / 298.257223563,
  ECCENTRICITY_2 = FLATTENING * (2 - FLATTENING);

type Vector = [number, number, number];

function fromCentre(longitude: number, latitude: number): Vector {
  const [lon, lat] = [radians(longitude), radians(latitude)],
    normal = EQUATOR / Math.sqrt(1 - ECCENTRICITY_2 * Math.sin(lat) ** 2);
  return [
    normal * Math.cos(lat) * Math.cos(lon),
    normal * Math.cos(lat) * Math.sin(lon),
    normal * (1 - ECCENTRICITY_2) * Math.sin(lat),
  ];
}

/** A map from [longitude, latitude]; distances within 1 km of the middle are true to a millimetre. */
export function localProjection([longitude, latitude]: Point): (place: Point) => Point {
  const middle = fromCentre(longitude, latitude),
    [lon, lat] = [radians(longitude), radians(latitude)];
  const [sinLon, cosLon, sinLat, cosLat] = [Math.sin(lon), Math.cos(lon), Math.sin(lat), Math.cos(lat)];
  return ([x, y]) => {
    const place = fromCentre(x, y),
      [dx, dy, dz] = [place[0] - middle[0], place[1] - middle[1], place[2] - middle[2]];
    return [-sinLon * dx + cosLon * dy, -sinLat * cosLon * dx - sinLat * sinLon * dy + cosLat * dz];
  };
}

/** Further apart, degrees, nobody draws a parking lot; metres of a lot reach further. */
const WIDEST = 0.5;
/** Of a whole province, half of the lines are at most so long, degrees; in metres nobody draws a lot of such lines. */
const SHORT = 0.01;

/** True if the coordinates of some lines read as degrees: all on the globe, and close together or each line short. */
export function areDegrees(lines: readonly (readonly Point[])[]): boolean {
  const { minX, minY, maxX, maxY } = boxOf(lines.flat());
  if (!(minX >= -180 && maxX <= 180 && minY >= -90 && maxY <= 90)) return false;
  if (maxX - minX <= WIDEST && maxY - minY <= WIDEST) return true;
  const lengths = lines
    .filter((points) => points.length > 1)
    .map((points) => {
      const box = boxOf(points);
      return Math.max(box.maxX - box.minX, box.maxY - box.minY);
    })
    .sort((a, b) => a - b);
  return lengths.length > 0 && nth(lengths, Math.floor(lengths.length / 2)) <= SHORT;
}
