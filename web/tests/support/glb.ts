/** Small GLB files for tests, which alter them. */
import { createHash } from 'node:crypto';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import type { FileData, GeometryRequest } from '../../src/decode/messages';
import { NO_GROWTH } from '../../src/decode/split/rule';

type Rows = Float32Array | Int8Array | Uint16Array | Uint32Array;
export type Json = Record<string, unknown>;

const COMPONENTS = new Map<unknown, number>([
  [Float32Array, 5126],
  [Int8Array, 5120],
  [Uint16Array, 5123],
  [Uint32Array, 5125],
]);
const TYPES = ['', 'SCALAR', 'VEC2', 'VEC3', 'VEC4'];

/** Collects arrays and their descriptions. */
export function createArrays() {
  const bufferViews: Json[] = [];
  const accessors: Json[] = [];
  const parts: Uint8Array[] = [];
  let size = 0;
  const append = (data: Uint8Array): number => {
    const start = size;
    const padded = new Uint8Array(4 * Math.ceil(data.length / 4));
    padded.set(data);
    parts.push(padded);
    size += padded.length;
    return start;
  };
  const describe = (view: Json, rows: Rows, width: number, count: number): number => {
    bufferViews.push(view);
    const componentType = COMPONENTS.get(rows.constructor);
    accessors.push({ bufferView: bufferViews.length - 1, componentType, count, type: TYPES[width] });
    return accessors.length - 1;
  };
  const bytesOf = (rows: Rows): Uint8Array => new Uint8Array(rows.buffer, rows.byteOffset, rows.byteLength);
  return {
    /** Appends rows of a number of columns, with gaps between rows if a stride is given; returns the accessor. */
    add(rows: Rows, width: number, stride = width * rows.BYTES_PER_ELEMENT): number {
      const row = width * rows.BYTES_PER_ELEMENT;
      const count = rows.length / width;
      const data = new Uint8Array(count * stride);
      for (let n = 0; n < count; n++) data.set(bytesOf(rows).subarray(n * row, (n + 1) * row), n * stride);
      const view = { buffer: 0, byteOffset: append(data), byteLength: data.length, byteStride: stride };
      return describe(view, rows, width, count);
    },
    /** Appends rows like `add`, but compressed. */
    pack(rows: Rows, width: number, mode: 'ATTRIBUTES' | 'TRIANGLES'): number {
      const byteStride = width * rows.BYTES_PER_ELEMENT;
      const count = rows.length / width;
      const data = MeshoptEncoder.encodeGltfBuffer(bytesOf(rows), count, byteStride, mode, 0);
      const packed = { buffer: 0, byteOffset: append(data), byteLength: data.length, byteStride, count, mode };
      const view = { buffer: 1, byteLength: rows.byteLength, extensions: { EXT_meshopt_compression: packed } };
      return describe(view, rows, width, count);
    },
    lists: () => ({ bufferViews, accessors, buffers: [{ byteLength: size }] }),
    chunk: () => Buffer.concat(parts),
  };
}
export type Arrays = ReturnType<typeof createArrays>;

/** Document with one primitive, and nodes below a root. */
export function documentOf(arrays: Arrays, primitive: Json, nodes: readonly Json[], root: Json = {}): Json {
  return {
    nodes: [{ ...root, children: nodes.map((_, n) => n + 1) }, ...nodes],
    meshes: [{ primitives: [{ material: 0, ...primitive }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [0.5, 0.25, 1, 1] } }],
    ...arrays.lists(),
  };
}

export function glbOf(document: unknown, chunk: Uint8Array): Uint8Array<ArrayBuffer> {
  const text = Buffer.from(typeof document === 'string' ? document : JSON.stringify(document));
  const data = new Uint8Array(28 + text.length + chunk.length);
  const words = new DataView(data.buffer);
  const head = [0x46546c67, 2, data.length, text.length, 0x4e4f534a];
  head.forEach((word, n) => words.setUint32(4 * n, word, true));
  data.set(text, 20);
  words.setUint32(20 + text.length, chunk.length, true);
  words.setUint32(24 + text.length, 0x004e4942, true);
  data.set(chunk, 28 + text.length);
  return data;
}

export function fileOf(name: string, data: Uint8Array<ArrayBuffer>): FileData {
  const sha256 = createHash('sha256').update(data).digest('hex');
  return { name, data: data.slice().buffer, bytes: data.length, sha256 };
}

export const NAME = 'files/00000000000000aa.glb';

export function requestOf(data: Uint8Array<ArrayBuffer>, changes: Partial<GeometryRequest> = {}): GeometryRequest {
  const glb = fileOf(NAME, data);
  const common = { parts: [], known: [], center: [0, 0, 0], growth: NO_GROWTH, isDynamic: false } as const;
  return { kind: 'geometry', glb, ...common, ...changes };
}
