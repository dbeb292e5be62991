/** Site plans as scenes: DXF, SVG, GeoJSON and OpenStreetMap extracts. Needs no WebAssembly. */
import type { Scenario, VehicleSpec } from "./index.js";

export interface SitePlanLine {
  points: [x: number, y: number][];
  closed: boolean;
}
/** Lines of one layer in the file's units, y up. */
export interface SitePlanLayer {
  name: string;
  lines: SitePlanLine[];
}

export interface SitePlan {
  kind: "dxf" | "svg" | "geojson" | "osm";
  layers: SitePlanLayer[];
  /** Metres per unit of the file; null where the file does not say it. GeoJSON and OpenStreetMap come in metres: 1. */
  metresPerUnit: number | null;
  /** What has been left out, in words. */
  notes: string[];
}

/** Why a file is no site plan, or why a choice of layers gives no scene. */
export declare class SitePlanError extends Error {
  readonly code: "bad-import";
  /** Of the file, from 1; undefined where the reason has no place. */
  readonly line: number | undefined;
  /** The rule with `{}` in the place of each value, as `ParkadeError` has it. */
  readonly template: string;
  readonly values: readonly string[];
}

/**
 * Reads a file by its name and contents. GeoJSON is in degrees of WGS 84 if all its coordinates are within half a
 * degree, otherwise in metres. At most 64 MB and 200,000 points. Throws `SitePlanError`.
 */
export declare function readSitePlan(name: string, content: string | Uint8Array): SitePlan;

/** What a layer is: lines that stop a car, closed things that do, bays, or the outline of the ground. */
export type Role = "none" | "wall" | "kerb" | "column" | "building" | "bay" | "ground";

export interface SitePlanOptions {
  /** By the layers' names; layers without one are left out. */
  roles: Readonly<Record<string, Role>>;
  metresPerUnit: number;
  /** Kept around bays, or around everything where there are none; metres, default 25. */
  around?: number;
  /** Default "sedan". */
  vehicle?: VehicleSpec;
  name?: string;
}

export interface SitePlanScene {
  scene: Scenario;
  /** Objects of the scene by the role of their layer. */
  counts: Record<Exclude<Role, "none">, number>;
  notes: string[];
}

/** A scene from a site plan; bays are free, the car stands before one of them. Throws `SitePlanError`. */
export declare function sceneFromSitePlan(plan: SitePlan, options: SitePlanOptions): SitePlanScene;

/** The role that a layer's name suggests. */
export declare function suggestedRole(name: string): Role;

/** Metres per unit: the file's, or those that give the plan the size of a parking lot. */
export declare function suggestedUnit(plan: SitePlan): number;
