/** Messages between the page and its workers. Arrays are transferred, not copied. */
import type { Point } from '../bundle/manifest';

/** How faces are drawn. */
export interface Material {
  /** Linear RGB and alpha. */
  readonly color: readonly [number, number, number, number];
  /** URI of the texture within the bundle ("files/…webp"), or null. */
  readonly image: string | null;
  /** Least alpha that is drawn, or null where nothing is cut out. */
  readonly cutoff: number | null;
}

/** Arrays of a mesh with one material, small enough to be uploaded in one frame. */
export interface Piece {
  /**
   * Three numbers a vertex, metres, y up: from the centre O of the region; where there are placements, in the mesh's
   * own frame.
   */
  readonly positions: Float32Array;
  /** Unit vectors, or null where faces are flat. */
  readonly normals: Float32Array | null;
  /** Two numbers a vertex, v downwards. */
  readonly uvs: Float32Array | null;
  /** Linear RGBA, four numbers a vertex, 65535 for 1. */
  readonly colors: Uint16Array | null;
  readonly indices: Uint16Array | Uint32Array;
  /** Twelve numbers a placement: rows of 3 × 4, from the mesh's frame to metres from O. */
  readonly placements: Float32Array | null;
  /** Equal for pieces with the same arrays, placements aside, in whatever file; null where nothing is known of others. */
  readonly same: string | null;
  readonly material: Material;
  /** Name of the dynamic object, or of the node. */
  readonly name: string;
}

export interface Geometry {
  readonly pieces: readonly Piece[];
  /** Pictures by URI, of those that the page does not have yet. */
  readonly images: Readonly<Record<string, ImageBitmap>>;
  /** Triangles drawn; a mesh with placements counts for each. */
  readonly triangles: number;
}

/** A file, and what the manifest says of it. */
export interface FileData {
  readonly name: string;
  readonly data: ArrayBuffer;
  readonly bytes: number;
  readonly sha256: string;
}

/** How R grows, and for whom: large triangles are split for it. */
export interface Growth {
  /** Radii at which R rests, metres, ascending: those of the rings from the first on. */
  readonly radii: readonly number[];
  /** n: nothing moves within n R. */
  readonly nearShare: number;
  /** Distance from O of the users for whom the error is bounded while R grows, metres. */
  readonly reach: number;
}

/** Decode the geometry of a ring, or of the dynamic objects. */
export interface GeometryRequest {
  readonly kind: 'geometry';
  readonly glb: FileData;
  /** Buffers that the worker was not sent before, and pictures. It keeps buffers, to which several files refer. */
  readonly parts: readonly FileData[];
  /** URIs of pictures that the page has. */
  readonly known: readonly string[];
  readonly center: Point;
  readonly growth: Growth;
  /** Each node is an object of its own, which can be posed. */
  readonly isDynamic: boolean;
}

/** Begin the maps of a region with ring 0: six pictures. */
export interface FirstMapRequest {
  readonly kind: 'first-map';
  readonly region: number;
  readonly faceSize: number;
  readonly tile: number;
  readonly across: number;
  /** Natural logarithm of the ratio of two consecutive codes' ranges. */
  readonly step: number;
  readonly color: readonly FileData[];
}

/** Apply the changes of the next ring. */
export interface NextMapRequest {
  readonly kind: 'next-map';
  readonly region: number;
  readonly ring: number;
  readonly tiles: readonly number[];
  readonly color: FileData | null;
  /** Six files for ring 1, one for others. */
  readonly range: readonly FileData[];
  /** The ring whose map the texture holds that is to be updated; null if it holds nothing. */
  readonly since: number | null;
}

/** Let go of buffers, by their names in the bundle, and of the maps of a region. */
export interface ForgetRequest {
  readonly kind: 'forget';
  readonly buffers: readonly string[];
  readonly region: number;
}

/** Buffers and maps that a worker keeps after it has forgotten others. */
export interface Kept {
  readonly buffers: number;
  readonly bytes: number;
  /** Regions whose maps it has. */
  readonly maps: number;
}

export type Request = GeometryRequest | FirstMapRequest | NextMapRequest | ForgetRequest;

/** Uploads that make a texture hold a ring's map. */
export type MapUpdate =
  | {
      readonly whole: true;
      /** sRGB codes, RGBA, by face, rows from the top. */
      readonly color: readonly Uint8Array[];
      /** Codes of range by face; null for ring 0. */
      readonly codes: readonly Uint16Array[] | null;
    }
  | {
      readonly whole: false;
      /** Numbers of tiles, ascending: by face, row and column. */
      readonly tiles: Int32Array;
      /** RGBA of the tiles, one after the other, rows from the top. */
      readonly color: Uint8Array;
      readonly codes: Uint16Array;
    };

export type Answer =
  | { readonly id: number; readonly result: Geometry | MapUpdate | Kept }
  | { readonly id: number; readonly error: string };

/** A request with its number. */
export type Job = Request & { readonly id: number };
