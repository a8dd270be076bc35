/** Compares the page's reader of trees with Python's, which serves stores and writes its results for each to a file. */
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { test } from 'node:test';
import type { Camera } from '../src/orthoview/cut/camera';
import { Cells, type Cut, cut } from '../src/orthoview/cut/cut';
import { createReader, type ViewRequest } from '../src/orthoview/decode/reader';
import { type Kind, StoreError } from '../src/orthoview/store/error';
import { createFiles } from '../src/orthoview/store/files';
import { GEOMETRY, geometryOf, shardPaths, type Triple } from '../src/orthoview/store/layout';
import { openRecords, type Shard } from '../src/orthoview/store/records';

interface Case {
  readonly camera: Camera;
  readonly views: number;
  readonly error: number;
  readonly around: boolean;
  readonly geometry: boolean;
  readonly lift: number;
  readonly reach: number;
  /** Level, place, distance, visibility and directions of each cell. */
  readonly cells: readonly (readonly [number, Triple, number, boolean, readonly number[]])[];
  /** Place, distance and visibility of each leaf that is drawn as geometry. */
  readonly leaves: readonly (readonly [Triple, number, boolean])[];
  /** All leaves whose files are needed, in any order. */
  readonly files: readonly Triple[];
  /** Number of cells that the build has not reached. */
  readonly unbuilt: number;
}

interface Told {
  readonly url: string;
  readonly cases: readonly Case[];
  /** Level, place and direction of views whose splats are stored. */
  readonly views: readonly View[];
  readonly output: string;
  /** Damaged or missing views and leaves, with the kind and message of the error. */
  readonly damaged: readonly { readonly view: View; readonly kind: Kind; readonly words: readonly string[] }[];
}

type View = readonly [number, Triple, number];

const file = process.env['NEARFAR_ORTHOVIEW'];
const stores: readonly Told[] = file ? JSON.parse(await readFile(file, 'utf8')) : [];
const skip = !file;

async function openStore({ url }: Told) {
  let received = 0;
  const base = new URL(url);
  const records = await openRecords(createFiles(base, (bytes) => (received += bytes)));
  const cells = new Cells(records.layout);
  const shards = new Map<string, Shard>(records.shards.map((shard) => [shard[0], shard]));
  const leafFiles = new Map<string, Shard>(records.geometry.map((shard) => [shard[0], shard]));
  return { base, records, cells, shards, leafFiles, received: () => received };
}

type Opened = Awaited<ReturnType<typeof openStore>>;

async function whole(
  { records, cells, shards, leafFiles }: Opened,
  { camera, views, error, around, geometry, lift }: Case,
): Promise<Cut> {
  for (;;) {
    const found = cut(cells, camera, { views, error, isAround: around, geometry, lift });
    for (const { tier, place } of found.unknown) {
      const subtree = await records.subtree(tier, place);
      cells.add(subtree);
      for (const shard of subtree.shards) shards.set(shard[0], shard);
      for (const shard of subtree.geometry) leafFiles.set(shard[0], shard);
    }
    if (found.unknown.length === 0) return found;
  }
}

async function checkCuts(store: Opened, cases: readonly Case[]): Promise<void> {
  for (const each of cases) {
    const { reach, cells, leaves, files, unbuilt } = each;
    const found = await whole(store, each);
    assert.ok(Math.abs(found.leafDistance / reach - 1) < 1e-12);
    assert.equal(found.unbuilt, unbuilt);
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
}

function wantedOf({ records, cells, shards, leafFiles }: Opened, [level, place, direction]: View): ViewRequest {
  const { layout } = records;
  const generation = cells.at(level, place)?.generation ?? 0;
  const named =
    direction === GEOMETRY
      ? geometryOf(layout, place).map((name) => leafFiles.get(name))
      : shardPaths(layout, { level, place, direction }, generation).map((path) => shards.get(path));
  return { level, place, direction, generation, shards: named.filter((shard) => shard !== undefined) };
}

const { signal } = new AbortController();

test('cuts equal those of tree.cut, and splats are read', { skip }, async () => {
  for (const told of stores) {
    const store = await openStore(told);
    await checkCuts(store, told.cases);
    const reader = createReader(store.base, store.records.layout, () => undefined);
    const read = async (view: View) => {
      const layers = await reader.read(wantedOf(store, view), signal);
      return layers.map(({ words, parts }) => ({ words: [...words], parts }));
    };
    const found: Awaited<ReturnType<typeof read>>[] = [];
    // Only a few at once, as in the page: small servers refuse more.
    for (let first = 0; first < told.views.length; first += 4) {
      found.push(...(await Promise.all(told.views.slice(first, first + 4).map(read))));
    }
    await writeFile(told.output, JSON.stringify(found));
  }
});

test('damaged and missing files are named', { skip }, async () => {
  for (const told of stores.filter(({ damaged }) => damaged.length > 0)) {
    const store = await openStore(told);
    for (const each of told.cases) await whole(store, each);
    const reader = createReader(store.base, store.records.layout, () => undefined);
    for (const { view, kind, words } of told.damaged) {
      const wanted = wantedOf(store, view);
      const read = view[2] === GEOMETRY ? reader.leaf(wanted, signal) : reader.read(wanted, signal);
      await assert.rejects(read, (error) => {
        assert.ok(error instanceof StoreError);
        assert.equal(error.kind, kind);
        for (const word of words) assert.ok(error.message.includes(word), error.message);
        return true;
      });
    }
  }
});
