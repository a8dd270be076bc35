/** Documents of a store: its layout, its generations, and the visible directions of a subtree's cells. */
import { inflate, sha256 } from '../../base/bytes';
import { messageOf } from '../../base/errors';
import { damaged, StoreError } from './error';
import type { Bytes, Files } from './files';
import {
  type Fields,
  fields,
  FOLDER,
  generationFolder,
  type Layout,
  nameOf,
  parseLayout,
  shapesOf,
  shardSide,
  subtreeOf as subtreeAt,
  type Triple,
} from './layout';

/** Value for a cell that is unchanged since the generations before. */
const AS_BEFORE = 0x8000_0000;

/** Value for a cell that an unfinished build has not reached, nor any cell below it. */
export const UNBUILT = 0x2000_0000;
/** Value for a cell whose views an unfinished build has not composed yet; cells below it may have views. */
export const PARTIAL = 0x4000_0000;

const RECORDS = `${FOLDER}/records.json`;
/** Message for a store without the list of records, which a server makes while the store is being built. */
const NOT_ENDED = 'the build of the tree has not ended: `nearfar view` shows what there is';

const VERSION = 1;
/** Greatest decompressed size of a list of guests, bytes. */
const MAX_GUEST_BYTES = 2 ** 26;

/** Path of a shard or a geometry file, with its generation's folder; its size; the prefix of its SHA-256. */
export type Shard = readonly [path: string, size: number, version: string];

/** Cells of a subtree from its record. */
export interface Subtree {
  readonly tier: number;
  readonly place: Triple;
  /** Per level, lowest first: bits of the directions in which cells show something, z fastest. */
  readonly masks: readonly Uint32Array[];
  /** Index of the generation in which each of these cells was computed. */
  readonly generations: readonly Uint16Array[];
  readonly shards: readonly Shard[];
  /** Geometry files of the leaves in the first generation. */
  readonly geometry: readonly Shard[];
  /** Guests by the name of a leaf: other leaves with triangles that extend into it. */
  readonly guests: ReadonlyMap<string, readonly Triple[]>;
}

export interface Records {
  readonly layout: Layout;
  readonly generation: number;
  /** Shards of all generations after the first. */
  readonly shards: readonly Shard[];
  /** Geometry files of these generations, newest first; a size of 0 marks a removed file. */
  readonly geometry: readonly Shard[];
  /** Reads the subtree at a tier and a place. */
  subtree(tier: number, place: Triple): Promise<Subtree>;
}

interface Overlay {
  readonly number: number;
  readonly cells: Fields;
}

/** Opens a store, also one whose build has not ended if its server lists records. */
export async function openRecords(files: Files): Promise<Records> {
  const attributes = await attributesOf(files);
  const layout = parseLayout(attributes['layout']);
  const generation = Number(attributes['generation']);
  if (!(Number.isInteger(generation) && generation >= 0)) throw damaged('zarr.json', 'expected a generation number');
  const hasEnded = attributes['complete'] === true || Object.keys(fields(attributes['failed'], 'zarr.json')).length > 0;
  const list = await readDocument(files, RECORDS, 'orthoview_records', hasEnded ? {} : { missing: NOT_ENDED });
  const digests = fields(list['records'], 'records.json');
  const overlays: Overlay[] = [];
  const [shards, geometry]: [Shard[], Shard[]] = [[], []];
  // Newest first.
  for (let number = generation; number > 0; number--) {
    const path = `${generationFolder(number)}generation.json`;
    const document = await readDocument(files, path, 'orthoview_generation');
    overlays.push({ number, cells: fields(document['cells'], path) });
    shards.push(...shardsOf(document['shards'], generationFolder(number), path));
    geometry.push(...shardsOf(document['geometry'], generationFolder(number), path));
  }
  return {
    layout,
    generation,
    shards,
    geometry,
    subtree: (tier, place) => subtreeOf(files, layout, overlays, digests, tier, place),
  };
}

async function subtreeOf(
  files: Files,
  layout: Layout,
  overlays: readonly Overlay[],
  digests: Fields,
  tier: number,
  place: Triple,
): Promise<Subtree> {
  const name = `${tier}_${place.join('_')}`;
  const shapes = shapesOf(layout, tier);
  const masks = shapes.map((count) => new Uint32Array(count).fill(AS_BEFORE));
  const generations = shapes.map((count) => new Uint16Array(count));
  const guests = new Map<string, Triple[]>();
  const addCells = async (cells: Fields, number: number, file: string): Promise<void> => {
    const newMasks = await masksOf(cells['views'], layout, shapes, file);
    for (const { index, leaf, guest } of await guestsOf(cells['guests'], layout, tier, place, file)) {
      if (masks[0]?.[index] !== AS_BEFORE) continue;
      const leafName = nameOf(0, leaf);
      guests.set(leafName, [...(guests.get(leafName) ?? []), guest]);
    }
    newMasks.forEach((newMask, level) => {
      const [mask, generation] = [masks[level], generations[level]];
      newMask.forEach((bits, index) => {
        if (!mask || !generation || mask[index] !== AS_BEFORE || bits === AS_BEFORE) return;
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
  let [shards, geometry]: [readonly Shard[], readonly Shard[]] = [[], []];
  if (digest !== undefined) {
    const file = `${FOLDER}/done/${name}.json`;
    const record = await readDocument(files, file, 'orthoview_subtree', { digest: String(digest) });
    await addCells(record, 0, file);
    shards = shardsOf(record['shards'], '', file);
    geometry = shardsOf(record['geometry'], '', file);
  }
  for (const mask of masks) mask.forEach((bits, index) => bits === AS_BEFORE && (mask[index] = 0));
  return { tier, place, masks, generations, shards, geometry, guests };
}

async function attributesOf(files: Files): Promise<Fields> {
  const file = 'zarr.json';
  const { bytes } = await files.read({ path: file, missing: 'there is no store of orthoviews at this address' });
  const attributes = fields(parseJson(bytes, file)['attributes'], file);
  return checkFormat(fields(attributes['nearfar'], file), file, 'orthoview');
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
    if (found !== null && found !== digest) throw damaged(path, `its SHA-256 is not ${digest}`);
  }
  return checkFormat(parseJson(bytes, path), path, kind);
}

function parseJson(bytes: Bytes, file: string): Fields {
  let parsed: unknown;
  try {
    parsed = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw damaged(file, 'expected JSON');
  }
  return fields(parsed, file);
}

/** Returns the document if its kind and version match. */
function checkFormat(found: Fields, file: string, kind: string): Fields {
  if (found['format'] !== `nearfar.${kind}`) throw damaged(file, `expected a document nearfar.${kind}`);
  if (found['version'] === VERSION) return found;
  throw new StoreError('newer', `${file}: version ${JSON.stringify(found['version'])}`);
}

async function masksOf(views: unknown, { directions }: Layout, shapes: readonly number[], file: string) {
  if (!Array.isArray(views) || views.length !== shapes.length)
    throw damaged(file, `expected views of ${shapes.length} levels`);
  const masks = await Promise.all(shapes.map((count, level) => wordsOf(views[level], 4 * count, 'views', file)));
  if (masks.some((mask, level) => mask.length !== shapes[level]))
    throw damaged(file, `views: expected levels of ${shapes} cells, got ${masks.map((mask) => mask.length)}`);
  const maskLimit = 2 ** directions.length;
  const special = [AS_BEFORE, UNBUILT, PARTIAL];
  const isWrong = (bits: number): boolean => bits >= maskLimit && !special.includes(bits);
  if (masks.some((mask) => mask.some(isWrong)))
    throw damaged(file, `views: expected bits of ${directions.length} directions`);
  return masks;
}

/** Leaves of a subtree, by index in it and by place, and their guests. */
async function guestsOf(text: unknown, layout: Layout, tier: number, place: Triple, file: string) {
  const words = await wordsOf(text, MAX_GUEST_BYTES, 'guests', file);
  if (words.length % 6 !== 0) throw damaged(file, `guests: expected rows of 6 numbers, got ${words.length} numbers`);
  const side = shardSide(layout, 0);
  return Array.from({ length: words.length / 6 }, (_, row) => {
    const tripleAt = (start: number): Triple => [...words.subarray(start, start + 3)] as unknown as Triple;
    const [leaf, guest] = [tripleAt(6 * row), tripleAt(6 * row + 3)];
    const isInSubtree = tier === 0 && subtreeAt(layout, 0, leaf).place.join() === place.join();
    const isInTree = guest.every((number, axis) => number < (layout.counts[axis] as number));
    if (!isInSubtree || !isInTree) throw damaged(file, 'guests: expected leaves of the subtree, and others of the tree');
    const [x, y, z] = leaf;
    return { index: ((x % side) * side + (y % side)) * side + (z % side), leaf, guest };
  });
}

/** Decodes little-endian uint32 numbers from base64 of zlib. Damaged data could decompress to more than `maxBytes`. */
async function wordsOf(text: unknown, maxBytes: number, what: string, file: string): Promise<Uint32Array> {
  let packed: Bytes;
  try {
    if (typeof text !== 'string') throw new TypeError('no text');
    packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    throw damaged(file, `${what}: expected base64`);
  }
  try {
    const bytes = await inflate(packed, maxBytes);
    if (bytes.length % 4 !== 0) throw new Error(`expected 32-bit numbers, got ${bytes.length} bytes`);
    const view = new DataView(bytes.buffer);
    return Uint32Array.from({ length: bytes.length / 4 }, (_, index) => view.getUint32(4 * index, true));
  } catch (reason) {
    throw damaged(file, `${what}: ${messageOf(reason)}`);
  }
}

function shardsOf(listed: unknown, folder: string, file: string): Shard[] {
  return Object.entries(fields(listed, file)).map(([path, entry]) => {
    const [size, digest]: unknown[] = Array.isArray(entry) ? entry : [];
    const isListed = typeof size === 'number' && typeof digest === 'string';
    if (!isListed) throw damaged(file, `${path}: expected a size and a hash`);
    return [folder + path, size, versionOf(digest)];
  });
}

/** Prefix of a hash for addresses. */
function versionOf(digest: string): string {
  return digest.slice(0, 16);
}
