/** The manifest of a bundle (python/nearfar/schemas/bundle.schema.json), as far as a client needs it. */

export type Point = readonly [number, number, number];

/** How near and far part are joined: by the blend of 2022, or on cylinders about the axis (CloVR). */
export type MorphKind = 'blend' | 'cylinder';

/** A file of the bundle. */
export interface Described {
  readonly bytes: number;
  readonly sha256: string;
}

/** What a ring changes of the map before it; ring 0 has six pictures and no tiles. */
export interface MapEntry {
  readonly tiles: readonly number[];
  readonly color: string | readonly string[] | null;
  readonly range: string | readonly string[] | null;
}

export interface RingEntry {
  readonly radius: number;
  readonly objects: number;
  readonly triangles: number;
  readonly geometry: string | null;
  readonly parts: readonly string[];
  readonly map: MapEntry;
}

export interface RegionEntry {
  readonly center: Point;
  readonly fold_margin: number;
  readonly neighbours: readonly number[];
  readonly range: { readonly least: number; readonly step: number };
  /** Radius at which static geometry ends and the map begins, metres; infinite where objects are whole. */
  readonly cut: number;
  readonly rings: readonly RingEntry[];
}

/** A dynamic object; matrices are rows. */
export interface MovingEntry {
  readonly object: string;
  readonly transform: readonly (readonly number[])[] | null;
}

export interface Manifest {
  readonly version: number;
  readonly morph: { readonly kind: MorphKind; readonly near_share: number };
  readonly growth: { readonly speed: number; readonly reach: number; readonly fade: number };
  readonly triangles: number;
  readonly bounds: readonly [Point, Point];
  readonly map: { readonly face_size: number; readonly tile: number; readonly across: number };
  readonly regions: readonly RegionEntry[];
  readonly dynamic: {
    readonly geometry: string;
    readonly parts: readonly string[];
    readonly triangles: number;
    readonly instances: readonly MovingEntry[];
  } | null;
  readonly notes: readonly string[];
  readonly files: Readonly<Record<string, Described>>;
}
