/** Manifest of a bundle (python/nearfar/schemas/bundle.schema.json), as far as a client needs it. */

export type Point = readonly [number, number, number];

/**
 * Morph between the near and the far part: blend (Popescu et al. 2022), or cylinders about the vertical axis (CloVR).
 */
export type MorphKind = 'blend' | 'cylinder';

/** Size and hash of a file of the bundle. */
export interface FileEntry {
  readonly bytes: number;
  readonly sha256: string;
}

/** Texels along an edge of a face and of a tile, and tiles in a row of a tile sheet. */
export type MapLayout = Readonly<Record<'face_size' | 'tile' | 'across', number>>;

/** `least`: range of code 0, metres; `step`: natural logarithm of the ratio between the ranges of consecutive codes. */
export type RangeScale = Readonly<Record<'least' | 'step', number>>;

/**
 * Map of a ring: the tiles that differ from the map of the ring before. A whole map, such as that of ring 0, has six
 * pictures and no tiles.
 */
export interface MapEntry {
  readonly tiles: readonly number[];
  readonly color: string | readonly string[] | null;
  readonly range: string | readonly string[] | null;
}

/** Objects that are sent together. */
export interface GroupEntry {
  readonly objects: number;
  readonly triangles: number;
  readonly geometry: string | null;
  readonly parts: readonly string[];
}

/** Full-size maps of a region, which replace coarse ones. */
export interface SharperMaps {
  readonly layout: MapLayout;
  readonly range: RangeScale;
  /** Map of ring 0, and the changes of each further ring. */
  readonly maps: readonly MapEntry[];
}

export interface RingEntry extends GroupEntry {
  readonly radius: number;
  /** Map beyond this ring; null if unknown. */
  readonly map: MapEntry | null;
  /** Full-size maps that replace the coarse ones; such a ring has no `map`. */
  readonly sharper?: SharperMaps;
}

/** Files that the strategies vis0 and vis1 load instead of rings: objects by footprint, and the last ring's map. */
export interface FootprintEntry {
  readonly portions: readonly GroupEntry[];
  readonly map: MapEntry;
}

export interface RegionEntry {
  readonly center: Point;
  readonly fold_margin: number;
  readonly neighbours: readonly number[];
  readonly range: RangeScale;
  /** Radius at which static geometry ends and the map begins, metres; infinite if objects are drawn whole. */
  readonly cut: number;
  readonly rings: readonly RingEntry[];
  readonly by_footprint: FootprintEntry | null;
  /** Whether the maps are coarse, except the last ring's: that ring repeats the one before it with full-size maps. */
  readonly isCoarse?: boolean;
}

/** A dynamic object; matrices are row-major. */
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
  readonly files: Readonly<Record<string, FileEntry>>;
}
