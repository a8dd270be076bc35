/** Messages between the page and its workers. Arrays are transferred, not copied. */
import type { Point } from '../bundle/manifest';

/** Codes of glTF and OpenGL for wrapping along u and v, and for the filter of magnified texels. */
export type Sampler = readonly [wrapU: number, wrapV: number, filter: number];

/** Material of faces. */
export interface Material {
  /** Linear RGB and alpha. */
  readonly color: readonly [number, number, number, number];
  /** URI of the texture in the bundle ("files/…webp"); null for none. */
  readonly image: string | null;
  readonly imageSampler: Sampler;
  /** Alpha cutoff; null for opaque surfaces. */
  readonly cutoff: number | null;
  /** Emitted light, linear RGB, which may exceed 1; null for none. */
  readonly emission: readonly [number, number, number] | null;
  /** URI of the texture that multiplies the emission; null for none. */
  readonly glow: string | null;
  readonly glowSampler: Sampler;
  /** Whether the colour is shown without lighting. */
  readonly isUnlit: boolean;
}

/** Arrays of a mesh with one material. */
export interface Piece {
  /** Vertex positions, metres, y up: in the mesh's frame if there are placements, else relative to the centre O. */
  readonly positions: Float32Array;
  /** Unit vectors, or null for flat shading. */
  readonly normals: Float32Array | null;
  /** Two numbers per vertex, v downwards. */
  readonly uvs: Float32Array | null;
  /** Linear RGBA, four numbers per vertex, 65535 for 1. */
  readonly colors: Uint16Array | null;
  readonly indices: Uint16Array | Uint32Array;
  /** Twelve numbers per placement: rows of 3 × 4, from the mesh's frame to metres from O. */
  readonly placements: Float32Array | null;
  /**
   * Key that pieces of any file share if their arrays, except placements, are equal; null if unknown. Only the first
   * such piece of a file has the arrays; they are empty in the others.
   */
  readonly sharedKey: string | null;
  readonly material: Material;
  /** Name of the dynamic object, or of the node. */
  readonly name: string;
}

/** Numbers of triangles; a mesh counts once for each placement. */
export interface Triangles {
  /** Triangles in the file. */
  readonly inFile: number;
  /** Drawn triangles, which are more if large ones were split. */
  readonly drawn: number;
}

/** Geometry of a file, whose parts the page then requests from the worker one by one. */
export interface Geometry {
  /** Number of the geometry, by which its parts are requested. */
  readonly number: number;
  readonly parts: number;
  /** One piece, without arrays, for each shader program that the geometry needs. */
  readonly samples: readonly Piece[];
  readonly triangles: Triangles;
}

/** Rows of a picture that the page does not have yet. */
export interface Band {
  /** URI of the picture within the bundle. */
  readonly name: string;
  /** Size of the whole picture, and the first row of the band. */
  readonly width: number;
  readonly height: number;
  readonly y: number;
  readonly bitmap: ImageBitmap;
}

/** Part of a file's geometry; bands of pictures come before the pieces that use them. */
export interface Part {
  readonly bands: readonly Band[];
  readonly pieces: readonly Piece[];
}

/** Content of a file, with its manifest entry. */
export interface FileData {
  readonly name: string;
  readonly data: ArrayBuffer;
  readonly bytes: number;
  readonly sha256: string;
}

/** Growth of R, and the users for whom large triangles are split. */
export interface Growth {
  /** Radii at which R rests, metres, ascending: those of rings 1 to n. */
  readonly radii: readonly number[];
  /** n: nothing moves within n R. */
  readonly nearShare: number;
  /** Greatest distance from O of users for whom the error is bounded while R grows, metres. */
  readonly reach: number;
}

/** Requests the geometry of a ring, or of the dynamic objects. */
export interface GeometryRequest {
  readonly kind: 'geometry';
  /** File; only its name if the worker has it, as the file of dynamic objects, which every region needs. */
  readonly glb: FileData | { readonly name: string; readonly data: null };
  /** Pictures, and buffers that the worker does not have yet. It caches buffers, which several files may use. */
  readonly parts: readonly FileData[];
  /** URIs of pictures that the page has. */
  readonly known: readonly string[];
  readonly center: Point;
  readonly growth: Growth;
  /** Whether each node is a separate object that can move. */
  readonly isDynamic: boolean;
}

/** Requests a part, whose arrays the worker transfers. The last part must be requested last. */
export interface PartRequest {
  readonly kind: 'part';
  /** Number of the geometry, and of its part. */
  readonly geometry: number;
  readonly part: number;
}

/** Discards the parts of a geometry that have not been requested. */
export interface DropRequest {
  readonly kind: 'drop';
  readonly geometry: number;
}

/** Begins the maps of a region with ring 0: six pictures. */
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

/** Applies the changes of the next ring. */
export interface NextMapRequest {
  readonly kind: 'next-map';
  readonly region: number;
  readonly ring: number;
  readonly tiles: readonly number[];
  readonly color: FileData | null;
  /** Six files for ring 1, one for later rings. */
  readonly range: readonly FileData[];
  /** Ring whose map is in the texture to update; null if the texture is empty. */
  readonly since: number | null;
}

/** Discards buffers, named as in the bundle, and the maps of a region. */
export interface ForgetRequest {
  readonly kind: 'forget';
  readonly buffers: readonly string[];
  readonly region: number;
}

/** Numbers of buffers and maps in a worker. */
export interface WorkerMemory {
  readonly buffers: number;
  readonly bytes: number;
  /** Number of regions with maps. */
  readonly maps: number;
}

export type Request = GeometryRequest | PartRequest | DropRequest | FirstMapRequest | NextMapRequest | ForgetRequest;

/** Sends requests to a worker. */
export interface Decoder {
  (request: GeometryRequest): Promise<Geometry>;
  (request: PartRequest): Promise<Part>;
  (request: DropRequest): Promise<null>;
  (request: FirstMapRequest | NextMapRequest): Promise<MapUpdate>;
  (request: ForgetRequest): Promise<WorkerMemory>;
}

/** Results of requests; null for no result. */
export type Result = Geometry | Part | MapUpdate | WorkerMemory | null;

/** Texels to upload so that a texture shows a ring's map. */
export type MapUpdate =
  | {
      readonly whole: true;
      /** sRGB colours, RGBA, by face, rows from the top. */
      readonly color: readonly Uint8Array[];
      /** Range codes by face; null for ring 0. */
      readonly codes: readonly Uint16Array[] | null;
    }
  | {
      readonly whole: false;
      /** Numbers of tiles, ascending: by face, row and column. */
      readonly tiles: Int32Array;
      /** RGBA of the tiles in order, rows from the top. */
      readonly color: Uint8Array;
      readonly codes: Uint16Array;
    };

/** Face of a tile, and its least coordinates in texels; a face has `perSide` × `perSide` tiles. */
export function tileAt(number: number, perSide: number, tile: number): { face: number; x: number; y: number } {
  const [column, row] = [number % perSide, Math.floor(number / perSide) % perSide];
  return { face: Math.floor(number / perSide ** 2), x: column * tile, y: row * tile };
}

export type Answer =
  | { readonly id: number; readonly result: Result }
  | { readonly id: number; readonly error: string };

/** A request with its number. */
export type Job = Request & { readonly id: number };
