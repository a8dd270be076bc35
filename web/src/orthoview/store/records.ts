/** Documents of a store: its layout, its generations, and the visible directions of a subtree's cells. */
import { sha256 } from '../../base/bytes';
import { damaged, StoreError } from './error';
import type { Bytes, Files } from './files';
import {
  fields,
  FOLDER,
  generationFolder,
  type Layout,
  nameOf,
  parseLayout,
  shapesOf,
  shardSide,
  subtreeOf as ownerOf,
  type Triple,
} from './layout';
import { checkFormat, documentOf, numbersOf, rowsOf } from './unpack';

/** Value for a cell that is unchanged since the generations before. */
const AS_BEFORE = 0x8000_0000;

const VERSION = 1;

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
  readonly cells: Readonly<Record<string, unknown>>;
}

/** Opens a complete store. */
export async function openRecords(files: Files): Promise<Records> {
  const attributes = await attributesOf(files);
  const layout = parseLayout(attributes['layout']);
  if (attributes['complete'] !== true) throw damaged('zarr.json', 'the tree is not complete; build it again');
  const generation = Number(attributes['generation']);
  if (!Number.isInteger(generation) || generation < 0)
    throw damaged('zarr.json', 'expected the number of a generation');
  const digests = fields(
    (await document(files, `${FOLDER}/records.json`, 'orthoview_records'))['records'],
    'records.json',
  );
  const overlays: Overlay[] = [];
  const [shards, geometry]: [Shard[], Shard[]] = [[], []];
  // Newest first.
  for (let number = generation; number > 0; number--) {
    const path = `${generationFolder(number)}generation.json`;
    const found = await document(files, path, 'orthoview_generation');
    overlays.push({ number, cells: fields(found['cells'], path) });
    shards.push(...shardsOf(found['shards'], generationFolder(number), path));
    geometry.push(...shardsOf(found['geometry'], generationFolder(number), path));
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
  digests: Readonly<Record<string, unknown>>,
  tier: number,
  place: Triple,
): Promise<Subtree> {
  const name = `${tier}_${place.join('_')}`;
  const shapes = shapesOf(layout, tier);
  const masks = shapes.map((count) => new Uint32Array(count).fill(AS_BEFORE));
  const generations = shapes.map((count) => new Uint16Array(count));
  const guests = new Map<string, Triple[]>();
  const put = async (cells: Readonly<Record<string, unknown>>, number: number, file: string): Promise<void> => {
    const known = await masksOf(cells['views'], layout, shapes, file);
    for (const [at, leaf, guest] of await guestsOf(cells['guests'], layout, tier, place, file)) {
      if (masks[0]?.[at] !== AS_BEFORE) continue;
      const name = nameOf(0, leaf);
      guests.set(name, [...(guests.get(name) ?? []), guest]);
    }
    known.forEach((own, level) => {
      const [mask, generation] = [masks[level], generations[level]];
      own.forEach((bits, at) => {
        if (!mask || !generation || mask[at] !== AS_BEFORE || bits === AS_BEFORE) return;
        mask[at] = bits;
        generation[at] = number;
      });
    });
  };
  for (const { number, cells } of overlays) {
    if (!Object.hasOwn(cells, name)) continue;
    const file = `${generationFolder(number)}generation.json`;
    await put(fields(cells[name], file), number, file);
  }
  const digest = digests[`${name}.json`];
  let [shards, geometry]: [readonly Shard[], readonly Shard[]] = [[], []];
  if (digest !== undefined) {
    const file = `${FOLDER}/done/${name}.json`;
    const record = await document(files, file, 'orthoview_subtree', String(digest));
    await put(record, 0, file);
    shards = shardsOf(record['shards'], '', file);
    geometry = shardsOf(record['geometry'], '', file);
  }
  for (const mask of masks) mask.forEach((bits, at) => bits === AS_BEFORE && (mask[at] = 0));
  return { tier, place, masks, generations, shards, geometry, guests };
}

async function attributesOf(files: Files): Promise<Readonly<Record<string, unknown>>> {
  const file = 'zarr.json';
  const found = await files.read({ path: file });
  if (!found) throw new StoreError('gone', `${file}: there is no store of orthoviews at this address`);
  let group: unknown;
  try {
    group = JSON.parse(new TextDecoder().decode(found.bytes));
  } catch {
    throw damaged(file, 'expected JSON');
  }
  return checkFormat(fields(fields(fields(group, file)['attributes'], file)['nearfar'], file), file, 'orthoview', VERSION);
}

async function document(
  files: Files,
  path: string,
  kind: string,
  digest?: string,
): Promise<Readonly<Record<string, unknown>>> {
  const found = await files.read(digest === undefined ? { path } : { path, version: versionOf(digest) });
  if (!found) throw new StoreError('gone', `${path}: the store refers to this file, and the server does not have it`);
  if (digest !== undefined) await compare(found.bytes, path, digest);
  return documentOf(found.bytes, path, kind, VERSION);
}

async function compare(bytes: Bytes, path: string, digest: string): Promise<void> {
  const found = await sha256(bytes);
  if (found !== null && found !== digest) throw damaged(path, `its SHA-256 is not ${digest}`);
}

async function masksOf(
  views: unknown,
  { directions }: Layout,
  shapes: readonly number[],
  file: string,
): Promise<Uint32Array[]> {
  if (!Array.isArray(views) || views.length !== shapes.length)
    throw damaged(file, `expected views of ${shapes.length} levels`);
  const masks = await Promise.all(shapes.map((count, level) => numbersOf(views[level], count, file)));
  const most = 2 ** directions.length;
  const isWrong = (bits: number): boolean => bits >= most && bits !== AS_BEFORE;
  if (masks.some((mask) => mask.some(isWrong)))
    throw damaged(file, `views: expected bits of ${directions.length} directions`);
  return masks;
}

/** Leaves of a subtree, by index in it and by place, and their guests. */
async function guestsOf(
  text: unknown,
  layout: Layout,
  tier: number,
  place: Triple,
  file: string,
): Promise<[at: number, leaf: Triple, guest: Triple][]> {
  const rows = await rowsOf(text, 6, file);
  const side = shardSide(layout, 0);
  return Array.from({ length: rows.length / 6 }, (_, n) => {
    const [a, b, c, x, y, z] = rows.subarray(6 * n, 6 * n + 6) as unknown as readonly number[] as [
      number,
      number,
      number,
      number,
      number,
      number,
    ];
    const isOwn = tier === 0 && ownerOf(layout, 0, [a, b, c]).place.join() === place.join();
    const isWithin = [x, y, z].every((number, axis) => number < (layout.counts[axis] as number));
    if (!isOwn || !isWithin) throw damaged(file, 'guests: expected leaves of the subtree, and others of the tree');
    return [((a % side) * side + (b % side)) * side + (c % side), [a, b, c], [x, y, z]];
  });
}

function shardsOf(listed: unknown, folder: string, file: string): Shard[] {
  return Object.entries(fields(listed, file)).map(([path, entry]) => {
    const [size, digest]: unknown[] = Array.isArray(entry) ? entry : [];
    if (typeof size !== 'number' || typeof digest !== 'string')
      throw damaged(file, `${path}: expected a size and a hash`);
    return [folder + path, size, versionOf(digest)];
  });
}

/** Prefix of a hash for addresses. */
function versionOf(digest: string): string {
  return digest.slice(0, 16);
}
