/** The page's reading of trees beside Python's, which writes a file of what it found and serves the stores. */
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { test } from 'node:test';
import type { Camera } from '../src/orthoview/cut/camera';
import { Cells } from '../src/orthoview/cut/cells';
import { type Cut, cut } from '../src/orthoview/cut/cut';
import { createReader } from '../src/orthoview/decode/reader';
import { createFiles } from '../src/orthoview/store/files';
import { arrayOf, channelsOf, overlay, shardOf, type Triple } from '../src/orthoview/store/layout';
import { openRecords, type Shard } from '../src/orthoview/store/records';

interface Case {
  readonly camera: Camera;
  readonly views: number;
  readonly error: number;
  readonly around: boolean;
  readonly geometry: boolean;
  readonly lift: number;
  readonly reach: number;
  /** Level, place, distance, whether it is in the picture, and directions of each cell. */
  readonly cells: readonly (readonly [number, Triple, number, boolean, readonly number[]])[];
  /** Place, distance and whether it is in the picture of each leaf that is drawn as geometry. */
  readonly leaves: readonly (readonly [Triple, number, boolean])[];
  /** All leaves whose files these need, in any order. */
  readonly files: readonly Triple[];
}

interface Told {
  readonly url: string;
  readonly cases: readonly Case[];
  /** Level, place and direction of views whose splats are written. */
  readonly views: readonly (readonly [number, Triple, number])[];
  readonly output: string;
}

const file = process.env['NEARFAR_ORTHOVIEW'];
const told: Told | null = file ? JSON.parse(await readFile(file, 'utf8')) : null;
const skip = told === null;

async function opened({ url }: Told) {
  let received = 0;
  const base = new URL(url);
  const records = await openRecords(createFiles(base, (bytes) => (received += bytes)));
  const cells = new Cells(records.layout);
  const shards = new Map<string, Shard>(records.shards.map((shard) => [shard[0], shard]));
  return { base, records, cells, shards, received: () => received };
}

type Opened = Awaited<ReturnType<typeof opened>>;

async function whole(
  { records, cells, shards }: Opened,
  { camera, views, error, around, geometry, lift }: Case,
): Promise<Cut> {
  for (;;) {
    const found = cut(cells, camera, { views, error, isAround: around, geometry, lift });
    for (const { tier, place } of found.unknown) {
      const subtree = await records.subtree(tier, place);
      cells.add(subtree);
      for (const shard of subtree.shards) shards.set(shard[0], shard);
    }
    if (found.unknown.length === 0) return found;
  }
}

test('cuts are those of tree.cut', { skip }, async () => {
  if (!told) return;
  const store = await opened(told);
  for (const each of told.cases) {
    const { reach, cells, leaves, files } = each;
    const found = await whole(store, each);
    assert.ok(Math.abs(found.reach / reach - 1) < 1e-12);
    const drawn = found.cells.map(({ level, place, isInPicture, directions }) => [
      level,
      place,
      isInPicture,
      directions,
    ]);
    assert.deepEqual(
      drawn,
      cells.map(([level, place, , isInPicture, directions]) => [level, place, isInPicture, directions]),
    );
    found.cells.forEach(({ distance }, at) =>
      assert.ok(Math.abs(distance - (cells[at]?.[2] as number)) < 1e-9 * (1 + distance)),
    );
    assert.deepEqual(
      found.leaves.map(({ place, isInPicture }) => [place, isInPicture]),
      leaves.map(([place, , isInPicture]) => [place, isInPicture]),
    );
    found.leaves.forEach(({ distance }, at) =>
      assert.ok(Math.abs(distance - (leaves[at]?.[1] as number)) < 1e-9 * (1 + distance)),
    );
    const needed = found.leaves.flatMap(({ place }) => [place, ...store.cells.guestsOf(place)].map(String));
    assert.deepEqual([...new Set(needed)].sort(), files.map(String).sort());
  }
});

test('splats are read', { skip }, async () => {
  if (!told) return;
  const store = await opened(told);
  const { base, records, cells, shards } = store;
  const { layout } = records;
  for (const each of told.cases) await whole(store, each);
  const reader = createReader(base, layout, () => undefined);
  const read = async ([level, place, direction]: Told['views'][number]) => {
    const generation = cells.at(level, place)?.generation ?? 0;
    const named = channelsOf(layout).map((channel) => {
      const array = arrayOf(layout, level, direction, channel);
      return shards.get(overlay(generation) + shardOf(layout, level, place, array));
    });
    const wanted = { level, place, direction, generation, shards: named.filter((shard) => shard !== undefined) };
    const layers = await reader.read(wanted, new AbortController().signal);
    return layers.map(({ words, parts }) => ({ words: [...words], parts }));
  };
  const found: Awaited<ReturnType<typeof read>>[] = [];
  // Some at once, as the page does: small servers take no more.
  for (let first = 0; first < told.views.length; first += 4) {
    found.push(...(await Promise.all(told.views.slice(first, first + 4).map(read))));
  }
  await writeFile(told.output, JSON.stringify(found));
});
