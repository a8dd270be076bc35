import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { deflateSync } from 'node:zlib';
import { sizeOf } from '../src/decode/files';
import { createMaps, type Maps } from '../src/decode/maps';
import type { FileData, FirstMapRequest, NextMapRequest } from '../src/decode/messages';
import { fileOf } from './support/glb';

const [SIZE, TILE, ACROSS] = [4, 2, 3] as const;
const NOTHING = 65535;

/** Header of a lossless WebP picture, which the fake browser below fills with one value. */
function picture(width: number, height: number, value: number): FileData {
  const data = new Uint8Array(32);
  data.set(Buffer.from('RIFF\0\0\0\0WEBPVP8L\0\0\0\0\x2f', 'latin1'));
  new DataView(data.buffer).setUint32(21, (width - 1) | ((height - 1) << 14), true);
  data[30] = value;
  return fileOf(`files/00000000000000${value.toString(16).padStart(2, '0')}.webp`, data);
}

/** Range file with these planes. */
function rangeFile(...planes: number[][]): FileData {
  const lengths = Buffer.alloc(36);
  planes.forEach((plane, number) => lengths.writeUInt32LE(plane.length, 4 * number));
  const data = deflateSync(Buffer.concat([lengths, ...planes.map((plane) => Buffer.from(plane))]));
  return fileOf('files/00000000000000ee.range', Uint8Array.from(data));
}

/** Fake of a canvas, which Node lacks. */
class Canvas {
  private readonly context = { value: 0 };
  constructor(
    private readonly width: number,
    private readonly height: number,
  ) {}
  getContext() {
    const { context, width, height } = this;
    return {
      drawImage: (bitmap: { value: number }) => (context.value = bitmap.value),
      getImageData: () => ({ data: new Uint8ClampedArray(4 * width * height).fill(context.value) }),
    };
  }
}
const browser = {
  OffscreenCanvas: Canvas,
  async createImageBitmap(blob: Blob) {
    const bytes = new Uint8Array(await blob.arrayBuffer());
    const [width, height] = sizeOf('', bytes);
    return { value: bytes[30], width, height, close: () => undefined };
  },
};
before(() => Object.assign(globalThis, browser));
after(() => Object.keys(browser).forEach((name) => Reflect.deleteProperty(globalThis, name)));

const FIRST: FirstMapRequest = {
  kind: 'first-map',
  region: 0,
  faceSize: SIZE,
  tile: TILE,
  across: ACROSS,
  step: 0.001,
  color: Array.from({ length: 6 }, (_, face) => picture(SIZE, SIZE, 10 + face)),
};
/** Ring 1 has no tiles and no surfaces: all predictions are right. */
const EMPTY = Array.from({ length: 6 }, () => rangeFile([], [0, 0]));
const RING_1: NextMapRequest = {
  kind: 'next-map',
  region: 0,
  ring: 1,
  tiles: [],
  color: null,
  range: EMPTY,
  since: null,
};
/** Ring 2 changes tile 4, the first of face 1: a bit marks the upper left texel, and the others are as predicted. */
const RING_2: NextMapRequest = {
  kind: 'next-map',
  region: 0,
  ring: 2,
  tiles: [4],
  color: picture(ACROSS * TILE, TILE, 99),
  range: [rangeFile([0x80], [0])],
  since: 1,
};

async function startMaps(): Promise<Maps> {
  const maps = createMaps();
  await maps.decodeFirst(FIRST);
  await maps.decodeNext(RING_1);
  return maps;
}

test('the first map is whole and has no ranges', async () => {
  const update = await createMaps().decodeFirst(FIRST);
  assert.ok(update.whole);
  assert.equal(update.codes, null);
  const ends = update.color.map((face) => [face.length, face[0], face.at(-1)]);
  assert.deepEqual(ends, [10, 11, 12, 13, 14, 15].map((value) => [64, value, value]));
});

test('a ring changes texels in its tiles and the neighbours of these texels', async () => {
  const maps = createMaps();
  await maps.decodeFirst(FIRST);
  const first = await maps.decodeNext(RING_1);
  assert.ok(first.whole);
  assert.ok(first.codes?.every((face) => face.every((code) => code === NOTHING)));
  const update = await maps.decodeNext(RING_2);
  assert.ok(!update.whole);
  assert.deepEqual([...update.tiles], [4]);
  // Alpha does not change.
  assert.deepEqual([...update.color], Array.from({ length: 16 }, (_, n) => (n % 4 === 3 ? 11 : 99)));
  assert.deepEqual([...update.codes], [NOTHING, NOTHING, NOTHING, NOTHING]);
});

test('tiles that changed since an older ring are returned together, in order', async () => {
  const maps = await startMaps();
  await maps.decodeNext({ ...RING_2, tiles: [12], since: null });
  const range = [rangeFile([0x88], [0])];
  const update = await maps.decodeNext({ ...RING_2, ring: 3, tiles: [4, 20], range, since: 1 });
  assert.ok(!update.whole);
  assert.deepEqual([...update.tiles], [4, 12, 20]);
});

test('a damaged ring leaves the map unchanged, so that it can be fetched again', async () => {
  const maps = createMaps();
  await maps.decodeFirst(FIRST);
  const truncate = (file: FileData): FileData => ({ ...file, data: file.data.slice(0, -1) });
  const cases: [changes: Partial<NextMapRequest>, message: RegExp][] = [
    [{ range: [...EMPTY.slice(1), truncate(RING_2.range[0] as FileData)] }, /expected \d+ bytes, as the manifest lists it/],
    [{ range: [...EMPTY.slice(1), rangeFile([], [0])] }, /files\/0+ee\.range: expected ranges of .* got fewer/],
    [{ range: [...EMPTY.slice(1), rangeFile([], [0, 0], [7])] }, /more bytes/],
    [{ range: EMPTY.slice(1) }, /six files/],
    [{ tiles: [24] }, /tile numbers below/],
    [{ tiles: [0.5] }, /tile numbers below/],
    [{ ring: 2 }, /expected ring 1, got 2/],
    [{ since: -1 }, /earlier ring/],
  ];
  for (const [changes, message] of cases) await assert.rejects(maps.decodeNext({ ...RING_1, ...changes }), message);
  await maps.decodeNext(RING_1);
  for (const [changes, message] of [
    [{ color: picture(TILE, TILE, 1) }, /expected 6 × 2 pixels, got 2 × 2/],
    [{ color: null }, /a picture of the tiles/],
    [{ range: [] }, /one range file if tiles change and none otherwise, got 0/],
    [{ range: [rangeFile([0x80], [0], new Array<number>(100).fill(0))] }, /compressed ranges, got more than/],
  ] satisfies [Partial<NextMapRequest>, RegExp][]) {
    await assert.rejects(maps.decodeNext({ ...RING_2, ...changes }), message);
  }
  const update = await maps.decodeNext({ ...RING_2, since: 0 });
  assert.ok(!update.whole);
  assert.equal(update.color[0], 99);
});

test('maps of impossible sizes are rejected', async () => {
  for (const changes of [{ faceSize: 1e9 }, { tile: 3 }, { across: 0 }, { faceSize: NaN }]) {
    await assert.rejects(createMaps().decodeFirst({ ...FIRST, ...changes }), /expected a face of at most 4096/);
  }
  await assert.rejects(createMaps().decodeFirst({ ...FIRST, color: FIRST.color.slice(1) }), /six pictures/);
  await assert.rejects(createMaps().decodeNext(RING_1), /before the first map/);
});

test('sizes are read from all three kinds of WebP files', () => {
  const head = (kind: string, rest: readonly number[]): Uint8Array => {
    const start = Buffer.from(`RIFF\0\0\0\0WEBP${kind}\0\0\0\0`, 'latin1');
    return Uint8Array.from([...start, ...rest, ...Array<number>(16).fill(0)]);
  };
  assert.deepEqual(sizeOf('x', head('VP8 ', [0, 0, 0, 0x9d, 1, 0x2a, 0x40, 0x41, 0x20, 0])), [320, 32]);
  assert.deepEqual(sizeOf('x', head('VP8L', [0x2f, 0xff, 0xc0, 0x0f, 0])), [256, 64]);
  assert.deepEqual(sizeOf('x', head('VP8X', [0, 0, 0, 0, 0xff, 0xff, 0, 1, 0, 0])), [65_536, 2]);
  for (const data of [new Uint8Array(40), head('ANIM', []), new Uint8Array(5)]) {
    assert.throws(() => sizeOf('files/x.webp', data), /files\/x\.webp: expected a WebP picture/);
  }
});
