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
  /** Linear RGB of the light that faces emit, which may exceed 1; null for none. */
  readonly emission: readonly [number, number, number] | null;
  /** URI of the texture that the emission is multiplied by, or null. */
  readonly glow: string | null;
  /** The colour is shown as it is, whatever the light. */
  readonly isUnlit: boolean;
}

/** Arrays of a mesh with one material. */
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
  /**
   * Equal for pieces with the same arrays, placements aside, in whatever file; null where nothing is known of others. Of
   * those of a file only the first one has the arrays, which are empty in others.
   */
  readonly same: string | null;
  readonly material: Material;
  /** Name of the dynamic object, or of the node. */
  readonly name: string;
}

/** Numbers of triangles; a mesh with placements counts for each. */
export interface Triangles {
  /** Those of the file. */
  readonly own: number;
  /** Those that are drawn: more, where large ones were split. */
  readonly drawn: number;
}

/** Geometry of a file; the worker keeps it, and gives its parts away one by one. */
export interface Geometry {
  /** Number by which parts are asked for. */
  readonly number: number;
  readonly parts: number;
  /** Pieces without arrays, one of each kind that needs a program of its own. */
  readonly samples: readonly Piece[];
  readonly triangles: Triangles;
}

/** Rows of a picture that the page does not have yet. */
export interface Band {
  /** URI of the picture within the bundle. */
  readonly name: string;
  /** Size of the whole picture, and the row at which the band begins. */
  readonly width: number;
  readonly height: number;
  readonly y: number;
  readonly rows: ImageBitmap;
}

/** Bands of pictures come before the pieces that show them. */
export interface Part {
  readonly bands: readonly Band[];
  readonly pieces: readonly Piece[];
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
  /** The name alone, if the worker has the file: that of dynamic objects, which every region needs. */
  readonly glb: FileData | { readonly name: string; readonly data: null };
  /** Buffers that the worker was not sent before, and pictures. It keeps buffers, to which several files refer. */
  readonly parts: readonly FileData[];
  /** URIs of pictures that the page has. */
  readonly known: readonly string[];
  readonly center: Point;
  readonly growth: Growth;
  /** Each node is an object of its own, which can be posed. */
  readonly isDynamic: boolean;
}

/** Give a part away; the last one is asked for last. */
export interface PartRequest {
  readonly kind: 'part';
  /** Number of the geometry, and of its part. */
  readonly of: number;
  readonly part: number;
}

/** Let go of parts that nobody will ask for. */
export interface DropRequest {
  readonly kind: 'drop';
  readonly of: number;
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

export type Request = GeometryRequest | PartRequest | DropRequest | FirstMapRequest | NextMapRequest | ForgetRequest;

/** Results of requests; null where there is nothing to tell. */
export type Result = Geometry | Part | MapUpdate | Kept | null;

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
  | { readonly id: number; readonly result: Result }
  | { readonly id: number; readonly error: string };

/** A request with its number. */
export type Job = Request & { readonly id: number };
