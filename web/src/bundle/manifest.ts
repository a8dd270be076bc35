/** The manifest of a bundle (python/nearfar/schemas/bundle.schema.json), as far as a client needs it. */

export type Point = readonly [number, number, number];

/** How near and far part are joined: by the blend of 2022, or on cylinders about the axis (CloVR). */
export type MorphKind = 'blend' | 'cylinder';

/** A file of the bundle. */
export interface Described {
  readonly bytes: number;
  readonly sha256: string;
}

/** Texels along a face and along a tile, and tiles in a row of a picture of tiles. */
export interface MapLayout {
  readonly face_size: number;
  readonly tile: number;
  readonly across: number;
}

/** The range of code 0, metres, and the natural logarithm of the ratio of two consecutive codes' ranges. */
export interface RangeScale {
  readonly least: number;
  readonly step: number;
}

/** Changes of a ring to the map before it; whole maps, such as that of ring 0, have six pictures and no tiles. */
export interface MapEntry {
  readonly tiles: readonly number[];
  readonly color: string | readonly string[] | null;
  readonly range: string | readonly string[] | null;
}

/** Objects that come together. */
export interface GroupEntry {
  readonly objects: number;
  readonly triangles: number;
  readonly geometry: string | null;
  readonly parts: readonly string[];
}

/** Maps of a region at full size, which take the place of coarse ones. */
export interface Sharper {
  readonly layout: MapLayout;
  readonly range: RangeScale;
  /** That of ring 0, and what each ring changes of it. */
  readonly maps: readonly MapEntry[];
}

export interface RingEntry extends GroupEntry {
  readonly radius: number;
  /** Of what lies after the ring; null where nothing tells what that is. */
  readonly map: MapEntry | null;
  /** Instead of a change of the map before, its like at full size. */
  readonly sharper?: Sharper;
}

/** Files that the strategies vis0 and vis1 load instead of rings: objects by their footprints, and the map of the last ring. */
export interface FootprintEntry {
  readonly portions: readonly GroupEntry[];
  readonly map: MapEntry;
}

export interface RegionEntry {
  readonly center: Point;
  readonly fold_margin: number;
  readonly neighbours: readonly number[];
  readonly range: RangeScale;
  /** Radius at which static geometry ends and the map begins, metres; infinite where objects are whole. */
  readonly cut: number;
  readonly rings: readonly RingEntry[];
  readonly by_footprint: FootprintEntry | null;
  /** Its maps are coarse until the last ring, which is the one before with maps of full size. */
  readonly isCoarse?: boolean;
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
  readonly map: MapLayout;
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
