/** Reads the GLB files that nearfar writes: their documents, and the arrays that these describe. */
import { MeshoptDecoder } from 'meshoptimizer/decoder';

/** Parts of a glTF 2.0 document, as far as nearfar writes them. Every number may be wrong in a damaged file. */
export interface Document {
  readonly nodes?: readonly Node[];
  readonly meshes?: readonly { readonly primitives: readonly Primitive[] }[];
  readonly materials?: readonly MaterialEntry[];
  readonly textures?: readonly {
    readonly source?: number;
    readonly extensions?: { readonly EXT_texture_webp?: { readonly source: number } };
  }[];
  readonly images?: readonly { readonly uri: string }[];
  readonly accessors?: readonly Accessor[];
  readonly bufferViews?: readonly View[];
  readonly buffers?: readonly { readonly uri?: string; readonly byteLength: number }[];
}

export interface Node {
  readonly mesh?: number;
  readonly name?: string;
  readonly translation?: readonly number[];
  readonly matrix?: readonly number[];
  readonly extensions?: { readonly EXT_mesh_gpu_instancing?: { readonly attributes: Readonly<Record<string, number>> } };
}

export interface Primitive {
  readonly attributes: Readonly<Record<string, number>>;
  readonly indices?: number;
  readonly material?: number;
}

export interface MaterialEntry {
  readonly pbrMetallicRoughness?: {
    readonly baseColorFactor?: readonly number[];
    readonly baseColorTexture?: { readonly index: number };
  };
  readonly alphaMode?: string;
  readonly alphaCutoff?: number;
}

interface Accessor {
  readonly bufferView: number;
  readonly byteOffset?: number;
  readonly componentType: number;
  readonly count: number;
  readonly type: string;
}

interface View {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride?: number;
  readonly extensions?: { readonly EXT_meshopt_compression?: Compression };
}

interface Compression {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride: number;
  readonly count: number;
  readonly mode: string;
  readonly filter?: string;
}

const MAGIC = 0x46546c67;
const [JSON_CHUNK, BIN_CHUNK] = [0x4e4f534a, 0x004e4942];
const WIDTHS: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
/** Greatest size of an array that is decompressed, bytes: the largest ring of a bundle has a fraction of it. */
const MOST_BYTES = 1 << 30;

const TYPES = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
} as const;
export type Numbers = InstanceType<(typeof TYPES)[keyof typeof TYPES]>;

export interface Glb {
  readonly document: Document;
  /** An accessor's rows, without gaps between them; `width` is the number of columns that it must have. */
  read(accessor: number | undefined, width: number): Promise<Numbers>;
}

/** Open a GLB. `parts` are the files that it refers to, by their URIs in it. */
export function openGlb(bytes: Uint8Array<ArrayBuffer>, parts: ReadonlyMap<string, Uint8Array>): Glb {
  const { document, chunk } = chunksOf(bytes);
  const decoded = new Map<number, Promise<Uint8Array>>();

  function bufferOf(number: number): Uint8Array {
    const entry = at(document.buffers, number, 'buffer');
    const found = entry.uri === undefined ? chunk : parts.get(entry.uri);
    if (!found) throw new Error(`buffer ${number} is not there`);
    return found;
  }

  async function viewOf(number: number): Promise<Uint8Array> {
    const view = at(document.bufferViews, number, 'view');
    const packed = view.extensions?.EXT_meshopt_compression;
    if (!packed) return slice(bufferOf(view.buffer), view.byteOffset ?? 0, view.byteLength);
    const { count, byteStride, mode, filter } = packed;
    if (!isSize(count) || !isSize(byteStride) || count * byteStride > MOST_BYTES) {
      throw new Error(`view ${number} claims ${count} rows of ${byteStride} bytes`);
    }
    const source = slice(bufferOf(packed.buffer), packed.byteOffset ?? 0, packed.byteLength);
    const target = new Uint8Array(count * byteStride);
    await MeshoptDecoder.ready;
    MeshoptDecoder.decodeGltfBuffer(target, count, byteStride, source, mode, filter);
    return target;
  }

  return {
    document,
    async read(number, width) {
      const accessor = at(document.accessors, number, 'accessor');
      const Type = TYPES[accessor.componentType as keyof typeof TYPES];
      if (!Type || WIDTHS[accessor.type] !== width || !isSize(accessor.count)) {
        throw new Error(`accessor ${number}: expected ${width} columns, got ${accessor.type}`);
      }
      const view = at(document.bufferViews, accessor.bufferView, 'view');
      let whole = decoded.get(accessor.bufferView);
      if (!whole) {
        whole = viewOf(accessor.bufferView);
        decoded.set(accessor.bufferView, whole);
      }
      const row = width * Type.BYTES_PER_ELEMENT;
      const stride = view.byteStride ?? view.extensions?.EXT_meshopt_compression?.byteStride ?? row;
      const start = accessor.byteOffset ?? 0;
      const data = await whole;
      if (accessor.count > 0 && start + (accessor.count - 1) * stride + row > data.length) {
        throw new Error(`accessor ${number} reaches beyond its array`);
      }
      const packed = new Uint8Array(accessor.count * row);
      if (stride === row) packed.set(data.subarray(start, start + packed.length));
      else {
        for (let n = 0; n < accessor.count; n++) {
          packed.set(data.subarray(start + n * stride, start + n * stride + row), n * row);
        }
      }
      return new Type(packed.buffer);
    },
  };
}

/** The entry of a list; an error that says what is missing. */
export function at<T>(list: readonly T[] | undefined, number: number | undefined, what: string): T {
  const found = number === undefined ? undefined : list?.[number];
  if (found === undefined) throw new Error(`${what} ${number} is not there`);
  return found;
}

function chunksOf(bytes: Uint8Array<ArrayBuffer>): { document: Document; chunk: Uint8Array | null } {
  const words = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20 || words.getUint32(0, true) !== MAGIC || words.getUint32(16, true) !== JSON_CHUNK) {
    throw new Error('expected a GLB, got something else');
  }
  const length = words.getUint32(12, true);
  const text = new TextDecoder().decode(slice(bytes, 20, length));
  const document: unknown = JSON.parse(text);
  if (typeof document !== 'object' || document === null) throw new Error('expected a glTF document, got something else');
  const next = 20 + length;
  if (bytes.length < next + 8) return { document, chunk: null };
  if (words.getUint32(next + 4, true) !== BIN_CHUNK) throw new Error('expected a binary chunk, got another one');
  return { document, chunk: slice(bytes, next + 8, words.getUint32(next, true)) };
}

function isSize(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}

function slice(data: Uint8Array, start: number, length: number): Uint8Array {
  if (!isSize(start) || !isSize(length) || start + length > data.length) throw new Error('an array reaches beyond the file');
  return data.subarray(start, start + length);
}
