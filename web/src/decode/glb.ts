/** Reads the GLB files that nearfar writes: documents, and arrays that meshoptimizer has compressed. */
import { MeshoptDecoder } from 'meshoptimizer/decoder';

/** Subset of glTF 2.0 that nearfar writes. In a damaged file any number may be wrong. */
export interface Document {
  readonly nodes?: readonly Node[];
  readonly meshes?: readonly { readonly primitives?: readonly Primitive[] }[];
  readonly materials?: readonly MaterialEntry[];
  readonly textures?: readonly {
    readonly source?: number;
    readonly sampler?: number;
    readonly extensions?: { readonly EXT_texture_webp?: { readonly source: number } };
  }[];
  readonly samplers?: readonly { readonly wrapS?: number; readonly wrapT?: number; readonly magFilter?: number }[];
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
  readonly extensions?: {
    readonly EXT_mesh_gpu_instancing?: { readonly attributes?: Readonly<Record<string, number>> };
  };
}

export interface Primitive {
  readonly attributes?: Readonly<Record<string, number>>;
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
  readonly emissiveFactor?: readonly number[];
  readonly emissiveTexture?: { readonly index: number };
  readonly extensions?: {
    readonly KHR_materials_unlit?: unknown;
    readonly KHR_materials_emissive_strength?: { readonly emissiveStrength?: number };
  };
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

const [MAGIC, VERSION] = [0x46546c67, 2];
const [JSON_CHUNK, BIN_CHUNK] = [0x4e4f534a, 0x004e4942];
const WIDTHS: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
/** Greatest number of rows of an array; real rings have far fewer. */
const MAX_ROWS = 2 ** 26;
/** Greatest number of bytes of all arrays of a file; real rings have far fewer. */
const MAX_BYTES: number = 2 ** 30;

const TYPES = {
  5120: Int8Array,
  5121: Uint8Array,
  5122: Int16Array,
  5123: Uint16Array,
  5125: Uint32Array,
  5126: Float32Array,
} as const;
export type Numbers = InstanceType<(typeof TYPES)[keyof typeof TYPES]>;

export type Glb = ReturnType<typeof openGlb>;

/** Opens a GLB. `parts` has the files that it refers to, by URI; all its arrays together may have `maxBytes` bytes. */
export function openGlb(bytes: Uint8Array<ArrayBuffer>, parts: ReadonlyMap<string, Uint8Array>, maxBytes = MAX_BYTES) {
  const { document, chunk } = chunksOf(bytes);
  const decoded = new Map<number, Promise<Uint8Array>>();
  let allocatedBytes = 0;

  /** Limits the total size: many entries of a damaged document may describe the same bytes. */
  function allocate(size: number): void {
    allocatedBytes += size;
    if (allocatedBytes > maxBytes) throw new Error(`the arrays take more than ${maxBytes} bytes`);
  }

  function bufferOf(number: number): Uint8Array {
    const entry = entryAt(document.buffers, number, 'buffer');
    const buffer = entry.uri === undefined ? chunk : parts.get(entry.uri);
    if (!buffer) throw new Error(`the buffer ${entry.uri ?? number} is missing`);
    return buffer;
  }

  async function viewOf(number: number): Promise<Uint8Array> {
    const view = entryAt(document.bufferViews, number, 'view');
    const packed = view.extensions?.EXT_meshopt_compression;
    if (!packed) return slice(bufferOf(view.buffer), view.byteOffset ?? 0, view.byteLength);
    const source = slice(bufferOf(packed.buffer), packed.byteOffset ?? 0, packed.byteLength);
    const data = await decompress(source, packed);
    allocate(data.length);
    return data;
  }

  return {
    document,
    /** Reads the rows of an accessor, tightly packed; `width` is the required number of columns. */
    async read(number: number | undefined, width: number): Promise<Numbers> {
      const accessor = entryAt(document.accessors, number, 'accessor');
      const { count, byteOffset: start = 0 } = accessor;
      const Type = TYPES[accessor.componentType as keyof typeof TYPES];
      if (!Type || WIDTHS[accessor.type] !== width || !isCount(count) || count > MAX_ROWS || !isCount(start))
        throw new Error(`accessor ${number}: expected rows of ${width} columns, got ${accessor.type}`);
      const view = entryAt(document.bufferViews, accessor.bufferView, 'view');
      const decoding = decoded.get(accessor.bufferView) ?? viewOf(accessor.bufferView);
      decoded.set(accessor.bufferView, decoding);
      const row = width * Type.BYTES_PER_ELEMENT;
      const stride = view.byteStride ?? view.extensions?.EXT_meshopt_compression?.byteStride ?? row;
      const data = await decoding;
      if (!isCount(stride) || stride < row) throw new Error(`accessor ${number}: expected rows of ${row} bytes`);
      if (count > 0 && start + (count - 1) * stride + row > data.length)
        throw new Error(`accessor ${number} reaches beyond its array`);
      allocate(count * row);
      const packed = new Uint8Array(count * row);
      if (stride === row) packed.set(data.subarray(start, start + packed.length));
      else {
        for (let n = 0, from = start; n < count; n++, from += stride)
          packed.set(data.subarray(from, from + row), n * row);
      }
      return new Type(packed.buffer);
    },
    /** File and position of an accessor's content; the file is '' for the GLB itself. */
    placeOf(number: number): string {
      const { bufferView, byteOffset = 0, count } = entryAt(document.accessors, number, 'accessor');
      const view = entryAt(document.bufferViews, bufferView, 'view');
      const { buffer, byteOffset: start = 0 } = view.extensions?.EXT_meshopt_compression ?? view;
      return `${entryAt(document.buffers, buffer, 'buffer').uri ?? ''}:${start}:${byteOffset}:${count}`;
    },
  };
}

/** Entry of a list; throws an error if it is missing, which `what` names. */
export function entryAt<T>(list: readonly T[] | undefined, number: number | undefined, what: string): T {
  if (number === undefined) throw new Error(`the ${what}'s number is missing`);
  const entry = Array.isArray(list) && isCount(number) ? (list as readonly T[])[number] : undefined;
  if (typeof entry !== 'object' || entry === null) throw new Error(`${what} ${number} is missing`);
  return entry;
}

/** Entries of a list; none if the list is missing. */
export function entries<T>(list: readonly T[] | undefined, what: string): readonly T[] {
  const isList = list === undefined || (Array.isArray(list) && list.every((item) => typeof item === 'object' && item));
  if (!isList) throw new Error(`expected a list of ${what}, got something else`);
  return list ?? [];
}

function chunksOf(bytes: Uint8Array<ArrayBuffer>): { document: Document; chunk: Uint8Array | null } {
  const words = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20 || words.getUint32(0, true) !== MAGIC || words.getUint32(16, true) !== JSON_CHUNK)
    throw new Error('expected a GLB, got something else');
  if (words.getUint32(4, true) !== VERSION) throw new Error(`expected version ${VERSION} of glTF, got another one`);
  const length = words.getUint32(12, true);
  const document = parseDocument(slice(bytes, 20, length));
  const next = 20 + length;
  if (bytes.length < next + 8) return { document, chunk: null };
  if (words.getUint32(next + 4, true) !== BIN_CHUNK) throw new Error('expected a binary chunk, got another one');
  return { document, chunk: slice(bytes, next + 8, words.getUint32(next, true)) };
}

function parseDocument(text: Uint8Array): Document {
  let document: unknown;
  try {
    document = JSON.parse(new TextDecoder().decode(text));
  } catch {
    throw new Error('expected a glTF document, got something else');
  }
  if (typeof document !== 'object' || document === null) throw new Error('expected a glTF document, got a value');
  return document;
}

function slice(data: Uint8Array, start: number, length: number): Uint8Array {
  const isWithin = isCount(start) && isCount(length) && start + length <= data.length;
  if (!isWithin) throw new Error('an array reaches beyond the file');
  return data.subarray(start, start + length);
}

/** Description of an array in `EXT_meshopt_compression`. In a damaged file any number may be wrong. */
export interface Compression {
  readonly buffer: number;
  readonly byteOffset?: number;
  readonly byteLength: number;
  readonly byteStride: number;
  readonly count: number;
  readonly mode: string;
  readonly filter?: string;
}

/** Greatest size of a decompressed array, bytes; real rings have far smaller ones. */
const MAX_ARRAY_BYTES = 2 ** 28;
/**
 * Greatest number of bytes to which a compressed byte decodes: version 0 of the vertex codec uses at least two bits for
 * 16 bytes of a column; the index codecs use at least a byte for a triangle or an index.
 */
const MAX_EXPANSION = 64;
/** Size that is allowed for any array, bytes: the last block of a short array may be padded. */
const MIN_ALLOWED_BYTES = 2 ** 16;
const MAX_STRIDE = 256;

type Strides = (stride: number) => boolean;
const isIndexStride: Strides = (stride) => stride === 2 || stride === 4;
const MODES: ReadonlyMap<string, Strides> = new Map([
  ['ATTRIBUTES', (stride: number) => stride % 4 === 0 && stride <= MAX_STRIDE],
  ['TRIANGLES', isIndexStride],
  ['INDICES', isIndexStride],
]);
const FILTERS: ReadonlyMap<string, Strides> = new Map([
  ['NONE', () => true],
  ['OCTAHEDRAL', (stride: number) => stride === 4 || stride === 8],
  ['QUATERNION', (stride: number) => stride === 8],
  ['EXPONENTIAL', (stride: number) => stride % 4 === 0],
]);

async function decompress(source: Uint8Array, { count, byteStride, mode, filter = 'NONE' }: Compression) {
  const isSized = isCount(count) && isCount(byteStride) && byteStride > 0;
  const size = count * byteStride;
  if (!isSized || size > Math.min(MAX_ARRAY_BYTES, MIN_ALLOWED_BYTES + MAX_EXPANSION * source.length))
    throw new Error(`${source.length} compressed bytes claim ${count} rows of ${byteStride} bytes`);
  if (!MODES.get(mode)?.(byteStride) || (mode === 'TRIANGLES' && count % 3 !== 0))
    throw new Error(`${count} rows of ${byteStride} bytes cannot be ${mode}`);
  if (!FILTERS.get(filter)?.(byteStride) || (mode !== 'ATTRIBUTES' && filter !== 'NONE'))
    throw new Error(`${mode} of ${byteStride} bytes have no filter ${filter}`);
  const target = new Uint8Array(size);
  await MeshoptDecoder.ready;
  try {
    MeshoptDecoder.decodeGltfBuffer(target, count, byteStride, source, mode, filter);
  } catch {
    throw new Error('expected a compressed array, got something else');
  }
  return target;
}

function isCount(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}
