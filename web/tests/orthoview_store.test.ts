/** Compares the page's reader of trees with Python's: a Python test serves stores and writes the expected results. */
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { test } from 'node:test';
import type { Camera } from '../src/orthoview/cut/camera';
import { Cells, type Cut, cut } from '../src/orthoview/cut/cut';
import { createReader, type ViewRequest } from '../src/orthoview/decode/reader';
import { Catalog } from '../src/orthoview/show/catalog';
import { type Kind, StoreError } from '../src/orthoview/store/error';
import { createFiles } from '../src/orthoview/store/files';
import { GEOMETRY, type Triple } from '../src/orthoview/store/layout';
import { openRecords } from '../src/orthoview/store/records';

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
  /** All leaves whose geometry files are needed, in any order. */
  readonly files: readonly Triple[];
  /** Number of cells that the build has not reached. */
  readonly unbuilt: number;
}

/** A served store and the expected results. */
interface StoreCase {
  readonly url: string;
  readonly cases: readonly Case[];
  /** Level, place and direction of views whose splats are stored. */
  readonly views: readonly View[];
  readonly output: string;
  /** Damaged or missing views and leaves, with the kind of the error and words of its message. */
  readonly damaged: readonly { readonly view: View; readonly kind: Kind; readonly words: readonly string[] }[];
}

type View = readonly [number, Triple, number];

const file = process.env['NEARFAR_ORTHOVIEW'];
const stores: readonly StoreCase[] = file ? JSON.parse(await readFile(file, 'utf8')) : [];
const skip = !file;

async function openStore({ url }: StoreCase) {
  let received = 0;
  const base = new URL(url);
  const records = await openRecords(createFiles(base, (bytes) => (received += bytes)));
  const cells = new Cells(records.layout);
  const catalog = new Catalog();
  catalog.add(records.shards, records.geometry);
  return { base, records, cells, catalog, received: () => received };
}

type Store = Awaited<ReturnType<typeof openStore>>;

/** Cuts a tree and loads unknown subtrees until the cut is complete. */
async function completeCut(
  { records, cells, catalog }: Store,
  { camera, views, error, around, geometry, lift }: Case,
): Promise<Cut> {
  for (;;) {
    const found = cut(cells, camera, { views, error, includesOutside: around, geometry, raiseDegrees: lift });
    for (const { tier, place } of found.unknown) {
      const subtree = await records.subtree(tier, place);
      cells.add(subtree);
      catalog.add(subtree.shards, subtree.geometry);
    }
    if (found.unknown.length === 0) return found;
  }
}

async function checkCuts(store: Store, cases: readonly Case[]): Promise<void> {
  for (const each of cases) {
    const { reach, cells, leaves, files, unbuilt } = each;
    const found = await completeCut(store, each);
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
    const needed = found.leaves.flatMap(({ place }) => [place, ...store.cells.leavesReachingInto(place)].map(String));
    assert.deepEqual([...new Set(needed)].sort(), files.map(String).sort());
  }
}

function requestOf({ cells, catalog }: Store, [level, place, direction]: View): ViewRequest {
  return catalog.request(cells, { level, place, direction });
}

const { signal } = new AbortController();

test('cuts equal those of tree.cut, and splats are read', { skip }, async () => {
  for (const expected of stores) {
    const store = await openStore(expected);
    await checkCuts(store, expected.cases);
    const reader = createReader(store.base, store.records.layout, () => undefined);
    const read = async (view: View) => {
      const layers = await reader.read(requestOf(store, view), signal);
      return layers.map(({ words, parts }) => ({ words: [...words], parts }));
    };
    const found: Awaited<ReturnType<typeof read>>[] = [];
    // A few at a time, as in the page: small servers refuse more.
    for (let first = 0; first < expected.views.length; first += 4) {
      found.push(...(await Promise.all(expected.views.slice(first, first + 4).map(read))));
    }
    await writeFile(expected.output, JSON.stringify(found));
  }
});

test('errors name the damaged or missing file', { skip }, async () => {
  for (const expected of stores.filter(({ damaged }) => damaged.length > 0)) {
    const store = await openStore(expected);
    for (const each of expected.cases) await completeCut(store, each);
    const reader = createReader(store.base, store.records.layout, () => undefined);
    for (const { view, kind, words } of expected.damaged) {
      const request = requestOf(store, view);
      const read = view[2] === GEOMETRY ? reader.leaf(request, signal) : reader.read(request, signal);
      await assert.rejects(read, (error) => {
        assert.ok(error instanceof StoreError);
        assert.equal(error.kind, kind);
        for (const word of words) assert.ok(error.message.includes(word), error.message);
        return true;
      });
    }
  }
});
