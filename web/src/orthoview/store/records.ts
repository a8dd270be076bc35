/** Reads the documents of a store: its layout, its generations, and the cells of its subtrees. */
import { inflate, sha256 } from '../../base/bytes';
import { messageOf } from '../../base/errors';
import { damagedError, StoreError } from './error';
import type { Bytes, Files } from './files';
import {
  type Fields,
  fields,
  FOLDER,
  generationFolder,
  type Layout,
  nameOf,
  parseLayout,
  cellCounts,
  shardSide,
  subtreeOf,
  type Triple,
} from './layout';

/** Mask of a cell that a generation does not change. */
const UNCHANGED = 0x8000_0000;

/** Mask of a cell that an unfinished build has not reached, nor any cell below it. */
export const UNBUILT = 0x2000_0000;
/** Mask of a cell whose views an unfinished build has not composed yet; cells below it may have views. */
export const PARTIAL = 0x4000_0000;

const RECORDS = `${FOLDER}/records.json`;
/** Message for a store without a list of records; during a build, `nearfar view` makes such a list. */
const NOT_ENDED = 'the build of the tree has not ended: `nearfar view` shows what there is';

/** Newest version of the attributes of a store, and of all other documents. */
const [STORE_VERSION, VERSION] = [2, 1];
/** Greatest decompressed size of a list of guests, bytes. */
const MAX_GUEST_BYTES = 2 ** 26;

/** Shard or geometry file: path in the store, size in bytes, and the first digits of its SHA-256. */
export type StoredFile = readonly [path: string, size: number, version: string];

/** Shard with the places of its chunks. */
export interface Shard {
  readonly file: StoredFile;
  /** Numbers of the cells of its chunks, in the order of the file. */
  readonly cells: Uint32Array;
  /** Offset of the first byte after each chunk. */
  readonly ends: Float64Array;
}

/** Cells of a subtree from its record. */
export interface Subtree {
  readonly tier: number;
  readonly place: Triple;
  /** Masks of the directions with non-empty views, for each level, lowest first; z changes fastest. */
  readonly masks: readonly Uint32Array[];
  /** Generations in which these cells were computed. */
  readonly generations: readonly Uint16Array[];
  readonly shards: readonly Shard[];
  /** Geometry files of the leaves in the first generation. */
  readonly geometry: readonly StoredFile[];
  /** Guests, other leaves whose triangles extend into a leaf, by the name of that leaf. */
  readonly guests: ReadonlyMap<string, readonly Triple[]>;
}

export interface Records {
  readonly layout: Layout;
  readonly generation: number;
  /** Shards of all generations after the first. */
  readonly shards: readonly Shard[];
  /** Geometry files of all generations after the first, newest first; a size of 0 marks a removed file. */
  readonly geometry: readonly StoredFile[];
  /** Reads a subtree. */
  subtree(tier: number, place: Triple): Promise<Subtree>;
}

/** Cells that a generation after the first changes, by the name of the subtree. */
interface Overlay {
  readonly number: number;
  readonly cells: Fields;
}

/** Opens a store; throws an error if its build has not ended and its server lists no records. */
export async function openRecords(files: Files): Promise<Records> {
  const attributes = await readAttributes(files);
  const layout = parseLayout(attributes['layout']);
  const generation = Number(attributes['generation']);
  if (!(Number.isInteger(generation) && generation >= 0))
    throw damagedError('zarr.json', 'expected a generation number');
  const hasEnded = attributes['complete'] === true || Object.keys(fields(attributes['failed'], 'zarr.json')).length > 0;
  const list = await readDocument(files, RECORDS, 'orthoview_records', hasEnded ? {} : { missing: NOT_ENDED });
  const digests = fields(list['records'], 'records.json');
  const overlays: Overlay[] = [];
  const [shards, geometry]: [Shard[], StoredFile[]] = [[], []];
  // Newest first.
  for (let number = generation; number > 0; number--) {
    const path = `${generationFolder(number)}generation.json`;
    const document = await readDocument(files, path, 'orthoview_generation');
    overlays.push({ number, cells: fields(document['cells'], path) });
    shards.push(...(await parseShards(document['shards'], layout, generationFolder(number), path)));
    geometry.push(...parseFiles(document['geometry'], generationFolder(number), path));
  }
  return {
    layout,
    generation,
    shards,
    geometry,
    subtree: (tier, place) => readSubtree(files, layout, overlays, digests, tier, place),
  };
}

async function readSubtree(
  files: Files,
  layout: Layout,
  overlays: readonly Overlay[],
  digests: Fields,
  tier: number,
  place: Triple,
): Promise<Subtree> {
  const name = `${tier}_${place.join('_')}`;
  const shapes = cellCounts(layout, tier);
  const masks = shapes.map((count) => new Uint32Array(count).fill(UNCHANGED));
  const generations = shapes.map((count) => new Uint16Array(count));
  const guests = new Map<string, Triple[]>();
  const addCells = async (cells: Fields, number: number, file: string): Promise<void> => {
    const newMasks = await decodeMasks(cells['views'], layout, shapes, file);
    for (const { index, leaf, guest } of await decodeGuests(cells['guests'], layout, tier, place, file)) {
      if (masks[0]?.[index] !== UNCHANGED) continue;
      const leafName = nameOf(0, leaf);
      guests.set(leafName, [...(guests.get(leafName) ?? []), guest]);
    }
    newMasks.forEach((newMask, level) => {
      const [mask, generation] = [masks[level], generations[level]];
      newMask.forEach((bits, index) => {
        if (!mask || !generation || mask[index] !== UNCHANGED || bits === UNCHANGED) return;
        mask[index] = bits;
        generation[index] = number;
      });
    });
  };
  for (const { number, cells } of overlays) {
    if (!Object.hasOwn(cells, name)) continue;
    const file = `${generationFolder(number)}generation.json`;
    await addCells(fields(cells[name], file), number, file);
  }
  const digest = digests[`${name}.json`];
  let [shards, geometry]: [readonly Shard[], readonly StoredFile[]] = [[], []];
  if (digest !== undefined) {
    const file = `${FOLDER}/done/${name}.json`;
    const record = await readDocument(files, file, 'orthoview_subtree', { digest: String(digest) });
    await addCells(record, 0, file);
    shards = await parseShards(record['shards'], layout, '', file);
    geometry = parseFiles(record['geometry'], '', file);
  }
  for (const mask of masks) mask.forEach((bits, index) => bits === UNCHANGED && (mask[index] = 0));
  return { tier, place, masks, generations, shards, geometry, guests };
}

async function readAttributes(files: Files): Promise<Fields> {
  const file = 'zarr.json';
  const { bytes } = await files.read({ path: file, missing: 'there is no store of orthoviews at this address' });
  const attributes = fields(parseJson(bytes, file)['attributes'], file);
  return checkFormat(fields(attributes['nearfar'], file), file, 'orthoview', STORE_VERSION);
}

async function readDocument(
  files: Files,
  path: string,
  kind: string,
  { digest, missing }: { readonly digest?: string; readonly missing?: string } = {},
): Promise<Fields> {
  const version = digest === undefined ? {} : { version: versionOf(digest) };
  const { bytes } = await files.read({ path, ...version, ...(missing === undefined ? {} : { missing }) });
  if (digest !== undefined) {
    const found = await sha256(bytes);
    if (found !== null && found !== digest) throw damagedError(path, `its SHA-256 is not ${digest}`);
  }
  return checkFormat(parseJson(bytes, path), path, kind);
}

function parseJson(bytes: Bytes, file: string): Fields {
  let parsed: unknown;
  try {
    parsed = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw damagedError(file, 'expected JSON');
  }
  return fields(parsed, file);
}

/** Returns the document if its kind and version match. */
function checkFormat(found: Fields, file: string, kind: string, version = VERSION): Fields {
  if (found['format'] !== `nearfar.${kind}`) throw damagedError(file, `expected a document nearfar.${kind}`);
  if (found['version'] === version) return found;
  if (Number(found['version']) < version)
    throw damagedError(file, 'the tree was built by an older version; build it again');
  throw new StoreError('newer', `${file}: version ${JSON.stringify(found['version'])}`);
}

async function decodeMasks(views: unknown, { directions }: Layout, shapes: readonly number[], file: string) {
  if (!Array.isArray(views) || views.length !== shapes.length)
    throw damagedError(file, `expected views of ${shapes.length} levels`);
  const masks = await Promise.all(shapes.map((count, level) => decodeWords(views[level], 4 * count, 'views', file)));
  if (masks.some((mask, level) => mask.length !== shapes[level]))
    throw damagedError(file, `views: expected levels of ${shapes} cells, got ${masks.map((mask) => mask.length)}`);
  const maskLimit = 2 ** directions.length;
  const special = [UNCHANGED, UNBUILT, PARTIAL];
  const isWrong = (bits: number): boolean => bits >= maskLimit && !special.includes(bits);
  if (masks.some((mask) => mask.some(isWrong)))
    throw damagedError(file, `views: expected bits of ${directions.length} directions`);
  return masks;
}

/** Pairs of a leaf, also by its index in the subtree, and one of its guests. */
async function decodeGuests(text: unknown, layout: Layout, tier: number, place: Triple, file: string) {
  const words = await decodeWords(text, MAX_GUEST_BYTES, 'guests', file);
  if (words.length % 6 !== 0)
    throw damagedError(file, `guests: expected rows of 6 numbers, got ${words.length} numbers`);
  const side = shardSide(layout, 0);
  return Array.from({ length: words.length / 6 }, (_, row) => {
    const tripleAt = (start: number): Triple => [...words.subarray(start, start + 3)] as unknown as Triple;
    const [leaf, guest] = [tripleAt(6 * row), tripleAt(6 * row + 3)];
    const isInSubtree = tier === 0 && subtreeOf(layout, 0, leaf).place.join() === place.join();
    const isInTree = guest.every((number, axis) => number < (layout.counts[axis] as number));
    if (!isInSubtree || !isInTree)
      throw damagedError(file, 'guests: expected leaves of the subtree, and others of the tree');
    const [x, y, z] = leaf;
    return { index: ((x % side) * side + (y % side)) * side + (z % side), leaf, guest };
  });
}

/** Decodes little-endian uint32 numbers, compressed by zlib, in base64; throws for more than `maxBytes` bytes. */
async function decodeWords(text: unknown, maxBytes: number, what: string, file: string): Promise<Uint32Array> {
  const bytes = await decodeBytes(text, maxBytes, what, file);
  if (bytes.length % 4 !== 0) throw damagedError(file, `${what}: expected 32-bit numbers, got ${bytes.length} bytes`);
  const view = new DataView(bytes.buffer);
  return Uint32Array.from({ length: bytes.length / 4 }, (_, index) => view.getUint32(4 * index, true));
}

/** Decodes bytes, compressed by zlib, in base64; throws for more than `maxBytes` bytes. */
async function decodeBytes(text: unknown, maxBytes: number, what: string, file: string): Promise<Bytes> {
  let packed: Bytes;
  try {
    if (typeof text !== 'string') throw new TypeError('no text');
    packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    throw damagedError(file, `${what}: expected base64`);
  }
  try {
    return await inflate(packed, maxBytes);
  } catch (reason) {
    throw damagedError(file, `${what}: ${messageOf(reason)}`);
  }
}

function parseFiles(listed: unknown, folder: string, file: string): StoredFile[] {
  return Object.entries(fields(listed, file)).map(([path, entry]) => {
    const [size, digest]: unknown[] = Array.isArray(entry) ? entry : [];
    const isListed = typeof size === 'number' && typeof digest === 'string';
    if (!isListed) throw damagedError(file, `${path}: expected a size and a hash`);
    return [folder + path, size, versionOf(digest)];
  });
}

async function parseShards(listed: unknown, layout: Layout, folder: string, file: string): Promise<Shard[]> {
  const packed = fields(listed, file);
  const parseShard = async (stored: StoredFile): Promise<Shard> => {
    const path = stored[0].slice(folder.length);
    const count = shardSide(layout, Number.parseInt(path, 10)) ** 3;
    const words = await decodeSplitWords((packed[path] as unknown[])[2], 8 * count, path, file);
    const cells = words.slice(0, words.length / 2);
    const ends = new Float64Array(cells.length);
    let [cell, end] = [0, 0];
    cells.forEach((step, index) => {
      // Steps between cells may be negative: sums of 32 bits wrap around.
      cell = (cell + step) >>> 0;
      end += words[cells.length + index] as number;
      [cells[index], ends[index]] = [cell, end];
    });
    if (cells.some((number) => number >= count) || end > stored[1])
      throw damagedError(file, `${path}: expected chunks of ${count} cells within ${stored[1]} bytes`);
    return { file: stored, cells, ends };
  };
  return Promise.all(parseFiles(listed, folder, file).map(parseShard));
}

/** Decodes numbers like `decodeWords`, but stored as all lowest bytes, then all second lowest ones and so on. */
async function decodeSplitWords(text: unknown, maxBytes: number, what: string, file: string): Promise<Uint32Array> {
  const bytes = await decodeBytes(text, maxBytes, what, file);
  if (bytes.length % 8 !== 0) throw damagedError(file, `${what}: expected a cell and a length for each chunk`);
  const count = bytes.length / 4;
  const byte = (plane: number, index: number): number => bytes[plane * count + index] as number;
  return Uint32Array.from(
    { length: count },
    (_, index) => byte(0, index) + 2 ** 8 * byte(1, index) + 2 ** 16 * byte(2, index) + 2 ** 24 * byte(3, index),
  );
}

/** First digits of a hash, as in addresses. */
function versionOf(digest: string): string {
  return digest.slice(0, 16);
}
