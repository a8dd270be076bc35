import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Band, Piece } from '../src/decode/messages';
import { packIntoParts, samplesOf, transferablesOf } from '../src/decode/pieces';
import { REPEATED } from '../src/decode/surfaces';

/** Creates a piece with a number of vertices. */
function piece(vertices: number, changes: Partial<Piece> = {}): Piece {
  return {
    positions: new Float32Array(3 * vertices).fill(1),
    normals: null,
    uvs: null,
    colors: null,
    indices: new Uint16Array(3 * vertices),
    placements: null,
    sharedKey: null,
    material: { color: [1, 1, 1, 1], image: null, imageSampler: REPEATED, cutoff: null, emission: null, glow: null,
      glowSampler: REPEATED, isUnlit: false },
    name: '',
    ...changes,
  };
}

function band(width: number, height: number): Band {
  return { name: 'files/a.webp', width, height, y: 0, bitmap: { width, height } as ImageBitmap };
}

test('parts have all pieces once and in order, a few each', () => {
  const pieces = Array.from({ length: 100 }, (_, n) => piece(1, { name: `${n}` }));
  const parts = packIntoParts([], pieces);
  assert.deepEqual(parts.flatMap((part) => part.pieces), pieces);
  assert.ok(parts.every((part) => part.pieces.length <= 32));
  assert.ok(parts.length <= 4);
});

test('parts have a limited size, unless one piece alone is larger', () => {
  const sizes = [100_000, 100_000, 100_000, 600_000, 10, 10];
  const parts = packIntoParts([], sizes.map((vertices) => piece(vertices)));
  assert.deepEqual(parts.map((part) => part.pieces.length), [2, 1, 1, 2]);
});

test('bands come before the pieces that use them', () => {
  const bands = Array.from({ length: 40 }, () => band(256, 256));
  const parts = packIntoParts(bands, [piece(1), piece(1)]);
  assert.deepEqual(parts.flatMap((part) => part.bands), bands);
  const order = parts.flatMap((part) => [...part.bands.map(() => 'band'), ...part.pieces.map(() => 'piece')]);
  assert.deepEqual(order, [...bands.map(() => 'band'), 'piece', 'piece']);
  assert.ok(parts.every((part) => part.bands.length <= 16));
});

test('arrays that pieces share are transferred once', () => {
  const first = piece(4, { sharedKey: 'm', normals: new Float32Array(12), placements: new Float32Array(12).fill(2) });
  const { placements } = first;
  // A second piece of the mesh with the same placements; the first piece with other placements.
  const pieces = [first, piece(5, { placements }), { ...first, placements: new Float32Array(24) }];
  const found = packIntoParts([], pieces).flatMap((part) => part.pieces);
  assert.deepEqual(found.map((each) => each.positions.length), [12, 15, 0]);
  assert.deepEqual(found.map((each) => each.placements?.length), [12, 12, 24]);
  assert.notEqual(found[1]?.placements, placements);
  assert.deepEqual(found[1]?.placements, placements);
  assert.deepEqual([found[2]?.normals?.length, found[2]?.uvs], [0, null]);
  const contents = packIntoParts([], pieces).flatMap(transferablesOf);
  assert.equal(new Set(contents).size, contents.length);
});

test('there is one sample, without arrays, for each kind of material and attributes', () => {
  const placements = new Float32Array(12);
  const plain = piece(3).material;
  const materials = [{ cutoff: 0.5 }, { emission: [1, 2, 0] as const }, { emission: [9, 9, 9] as const }, { isUnlit: true }];
  const others = materials.map((change) => piece(3, { material: { ...plain, ...change } }));
  const pieces = [piece(3), piece(4), piece(3, { placements }), ...others, piece(9, { placements })];
  const samples = samplesOf(pieces);
  const kinds = samples.map(({ placements: rows, material }) => [rows?.length ?? null, material]);
  const different = materials.filter((_, n) => n !== 2).map((change) => [null, { ...plain, ...change }]);
  assert.deepEqual(kinds, [[null, plain], [0, plain], ...different]);
  assert.ok(samples.every(({ positions, indices }) => positions.length + indices.length === 0));
});
