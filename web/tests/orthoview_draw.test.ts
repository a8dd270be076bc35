/** Preparation of pictures: bounds of parts, order of the work, GPU memory, bands of samples, choice of a device. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cameraOf } from '../src/orthoview/cut/camera';
import { liftOf } from '../src/orthoview/cut/cut';
import type { Part } from '../src/orthoview/decode/pack';
import { type Model, modelOf, type Projector, projectorOf, boundsOf, projectView } from '../src/orthoview/draw/projection';
import { Arena, type PageRange, UNIFORM_STRIDE } from '../src/orthoview/draw/webgpu/buffers';
import { Uniforms } from '../src/orthoview/draw/webgpu/kernels';
import { bandsOf } from '../src/orthoview/draw/webgpu/samples';
import { batchesOf, PART_WORDS, workOf } from '../src/orthoview/draw/webgpu/work';
import { deviceOf } from '../src/orthoview/show/start';
import { parseLayout, type Triple } from '../src/orthoview/store/layout';
import { randomOf } from './support/random';

const LAYOUT = parseLayout({
  origin: [0, 0, 0],
  cell: 10,
  counts: [4, 4, 4],
  levels: 3,
  directions: [
    [0, 0, 1],
    [1, 0, 0],
    [0, 1, 0],
  ],
  names: ['pz', 'px', 'py'],
  size: 8,
  depth_bits: 12,
  normal_bits: 16,
  subtree: 3,
  color: 'zstd',
  quality: null,
  geometry: false,
  layers: 1,
});

function randomProjector(random: () => number): Projector {
  const place = (): number => 60 * random() - 10;
  const pose = {
    position: [place(), place(), place()] as const,
    yaw: 2 * Math.PI * random(),
    pitch: 2 * random() - 1,
  };
  return projectorOf(cameraOf(pose, 1, 64, 48));
}

/** A random view, and a part of it at a random place. */
function randomView(random: () => number, count: number): { readonly model: Model; readonly part: Part } {
  const low = [0, 1, 2].map((axis) => Math.floor(random() * (axis < 2 ? 7 : 4000))) as unknown as Triple;
  const high = low.map((lowest, axis) => lowest + 1 + Math.floor(random() * (axis < 2 ? 2 : 90))) as unknown as Triple;
  const place = [0, 1, 2].map(() => Math.floor(4 * random())) as unknown as Triple;
  return { model: modelOf(LAYOUT, 0, place, Math.floor(3 * random())), part: { first: 0, count, low, high } };
}

/** Projected random point of one of a part's splats, which extend at most half a pixel beyond their pixel. */
function randomSplatPoint(
  { model, part }: ReturnType<typeof randomView>,
  { eye, rows }: Projector,
  random: () => number,
): Triple {
  const at = part.low.map((lowest, axis) => {
    const place = lowest + random() * ((part.high[axis] as number) - lowest);
    return axis === 2 ? place : place + (random() < 0.5 ? -0.35 : 0.35);
  });
  const world = [0, 1, 2].map((axis) =>
    at.reduce((sum, steps, n) => sum + steps * (model.steps[n]?.[axis] as number), model.start[axis] as number),
  );
  return rows.map((row) =>
    row.reduce((sum, factor, axis) => sum + factor * ((world[axis] as number) - (eye[axis] as number)), 0),
  ) as unknown as Triple;
}

test('points of a part lie within its bounds, and are not nearer than its nearness', () => {
  const random = randomOf(7);
  let [insideCount, invisibleCount] = [0, 0];
  for (let turn = 0; turn < 400; turn++) {
    const [projector, view] = [randomProjector(random), randomView(random, 1)];
    const projected = projectView(view.model, projector);
    const bounds = boundsOf(projected, view.part, projector.width, projector.height);
    invisibleCount += bounds ? 0 : 1;
    for (let n = 0; n < 40; n++) {
      const [x, y, w] = randomSplatPoint(view, projector, random);
      const [column, row] = [x / w, y / w];
      if (w < projected.minW || column < 0 || row < 0 || column >= projector.width || row >= projector.height) continue;
      insideCount += 1;
      assert.ok(bounds);
      assert.ok(bounds.nearness >= 1 / w);
      assert.ok(column >= bounds.low[0] && column < bounds.high[0] && row >= bounds.low[1] && row < bounds.high[1]);
    }
  }
  assert.ok(insideCount > 500 && invisibleCount > 100);
});

test('the work has each visible part once, nearest parts first, in batches by numbers of splats', () => {
  const random = randomOf(11);
  const projector = projectorOf(cameraOf({ position: [20, 20, 60], yaw: 0, pitch: 0 }, 1, 64, 48));
  const items = Array.from({ length: 200 }, (_, n) => {
    const { model, part } = randomView(random, 1 + Math.floor(40 * random()));
    return { layer: { model, parts: [part], page: `page ${n % 3}`, first: 1000 * n }, box: null };
  });
  const { views, parts, partOrder, pages, calls, splats } = workOf(items, projector, LAYOUT, 0.5);
  const count = parts.length / PART_WORDS;
  assert.ok(count > 20);
  assert.equal(views.length, 40 * count);
  assert.deepEqual([...pages].sort(), ['page 0', 'page 1', 'page 2']);
  const rows = Array.from({ length: count }, (_, n) => [...parts.subarray(PART_WORDS * n, PART_WORDS * (n + 1))]);
  const column = (at: number): number[] => rows.map((row) => row[at] as number);
  const [firsts, counts, numbers, depthBits, pageNumbers] = [column(1), column(2), column(3), column(4), column(7)];
  assert.equal(new Set(firsts).size, count);
  assert.equal(
    counts.reduce((sum, each) => sum + each, 0),
    splats,
  );
  // Splat numbers follow the order of the items, without gaps.
  let next = 0;
  for (const part of partOrder) {
    assert.equal(numbers[part], next);
    next += counts[part] as number;
  }
  assert.deepEqual(
    [...partOrder].map((part) => firsts[part]),
    [...firsts].sort((a, b) => a - b),
  );
  // Calls are consecutive, each has one page, and the parts of a batch are nearer than those of the next batch.
  let [at, farthest, nearest] = [0, Number.POSITIVE_INFINITY, 0];
  for (const { page, first, count: length, startsBatch } of calls) {
    assert.equal(first, at);
    at += length;
    if (startsBatch) [farthest, nearest] = [Math.min(farthest, nearest || farthest), Number.POSITIVE_INFINITY];
    for (let n = first; n < at; n++) {
      assert.equal(pages[pageNumbers[n] as number], page);
      assert.ok((depthBits[n] as number) <= farthest);
      nearest = Math.min(nearest, depthBits[n] as number);
    }
  }
  assert.equal(at, count);
  assert.ok(calls.length > 5);
});

test('an empty picture needs no work', () => {
  const { parts, calls, splats } = workOf([], randomProjector(randomOf(1)), LAYOUT, 0.5);
  assert.deepEqual([parts.length, calls.length, splats], [0, 0, 0]);
});

test('batches grow, and the last one has the rest', () => {
  const sizes = (counts: readonly number[]): number[] => {
    const parts = counts.map((count) => ({ count }));
    const all = counts.reduce((sum, count) => sum + count, 0);
    return batchesOf(parts, all).map(({ length }) => length);
  };
  assert.deepEqual(sizes(new Array(32).fill(64)), [2, 2, 4, 8, 16]);
  assert.deepEqual(sizes([1000, 1, 1]), [1, 2]);
  assert.deepEqual(sizes([]), []);
});

/** Device with the methods that allocation uses; `sizes` has the sizes of its buffers. */
function fakeDevice(maxBytes: number): GPUDevice & { readonly sizes: number[] } {
  Object.assign(globalThis, { GPUBufferUsage: { STORAGE: 128, COPY_DST: 8 } });
  const sizes: number[] = [];
  const limits = { maxBufferSize: maxBytes, maxStorageBufferBindingSize: maxBytes, maxTextureDimension2D: 8192 };
  const createBuffer = ({ size }: GPUBufferDescriptor): object => {
    sizes.push(size);
    return { destroy: () => sizes.splice(sizes.indexOf(size), 1) };
  };
  return { sizes, limits, createBuffer, queue: { writeBuffer: () => undefined } } as unknown as GPUDevice & {
    readonly sizes: number[];
  };
}

test('allocations on the GPU never overlap, and pages are freed with their last view', () => {
  const [random, device] = [randomOf(3), fakeDevice(1 << 27)];
  const arena = new Arena(device);
  const ranges: PageRange[] = [];
  for (let turn = 0; turn < 3000; turn++) {
    if (ranges.length > 0 && random() < 0.48) {
      const [range] = ranges.splice(Math.floor(random() * ranges.length), 1);
      arena.free(range as PageRange);
    } else ranges.push(arena.put(new Uint32Array(1 + Math.floor(400_000 * random()))));
    if (turn % 100 > 0) continue;
    for (const page of new Set(ranges.map((range) => range.page))) {
      const pageRanges = ranges.filter((range) => range.page === page).sort((a, b) => a.first - b.first);
      let end = 0;
      for (const { first, words } of pageRanges) {
        assert.ok(first >= end && first + words <= page.words);
        end = first + words;
      }
      const free = page.gaps.reduce((sum, { words }) => sum + words, 0);
      assert.equal(
        pageRanges.reduce((sum, { words }) => sum + words, free),
        page.words,
      );
    }
  }
  assert.ok(device.sizes.length > 1);
  for (const range of ranges) arena.free(range);
  assert.deepEqual(device.sizes, []);
});

test('a view larger than any buffer is rejected', () => {
  const arena = new Arena(fakeDevice(1 << 20));
  arena.put(new Uint32Array(1 << 18));
  assert.throws(() => arena.put(new Uint32Array((1 << 18) + 1)), /larger than the graphics device allows/);
});

test('bands cover all rows of a picture once, in whole pixels', () => {
  const device = fakeDevice(1 << 27);
  assert.deepEqual(bandsOf(device, 640, 480, 1), [{ number: 0, first: 0, rows: 480 }]);
  const bands = bandsOf(device, 4 * 3840, 4 * 2160, 4);
  assert.ok(bands.length > 1);
  let next = 0;
  for (const [n, { number, first, rows }] of bands.entries()) {
    assert.deepEqual([number, first, first % 4, rows % 4], [n, next, 0, 0]);
    assert.ok(4 * 4 * 3840 * rows <= 1 << 26 && rows <= 8192);
    next += rows;
  }
  assert.equal(next, 4 * 2160);
});

test('uniforms of calls lie in separate slots', () => {
  const projector = randomProjector(randomOf(5));
  const uniforms = new Uniforms({ projector, grid: 2, nearest: 0.25, parts: 9 }, 2);
  const band = { number: 0, first: 8, rows: 24 };
  assert.deepEqual([uniforms.put(band, {}), uniforms.put(band, { first: 3, count: 4, round: 1, page: 2 })], [0, UNIFORM_STRIDE]);
  const [floats, integers] = [new Float32Array(uniforms.all.buffer, UNIFORM_STRIDE), new Uint32Array(uniforms.all.buffer, UNIFORM_STRIDE)];
  assert.deepEqual([...integers.subarray(24, 34)], [64, 24, 8, 2, 3, 4, 1, 0, 9, 2]);
  assert.equal(floats[36], 0.25);
  assert.deepEqual([...floats.subarray(8, 11)], [...new Float32Array(projector.rows[2])]);
});

test('directions are raised towards the zenith, and not beyond it', () => {
  const lift = liftOf(30);
  const assertClose = (found: Triple, expected: Triple): void => {
    for (const axis of [0, 1, 2]) assert.ok(Math.abs((found[axis] as number) - (expected[axis] as number)) < 1e-12);
  };
  assertClose(lift([1, 0, 0]), [Math.cos(Math.PI / 6), 0.5, 0]);
  assertClose(lift([0, Math.sin(1.2), Math.cos(1.2)]), [0, 1, 0]);
  assertClose(lift([0, -1, 0]), [0, -1, 0]);
  assert.deepEqual(liftOf(0)([0.6, 0, 0.8]), [0.6, 0, 0.8]);
});

test('software rendering is used only if requested by name', async () => {
  const limits = { maxBufferSize: 7, maxStorageBufferBindingSize: 8, maxTextureDimension2D: 9, maxBindGroups: 4 };
  const adapter = (isFallbackAdapter: boolean) => ({
    info: { isFallbackAdapter },
    limits,
    requestDevice: async ({ requiredLimits }: GPUDeviceDescriptor) => requiredLimits,
  });
  const findGraphics = async (gpu: object | null | undefined, isNamed: boolean): Promise<unknown> => {
    const value = gpu === undefined ? {} : { gpu: { requestAdapter: async () => gpu } };
    Object.defineProperty(globalThis, 'navigator', { value, configurable: true });
    return deviceOf(isNamed);
  };
  const { maxBindGroups: _, ...raisedLimits } = limits;
  for (const isNamed of [false, true]) {
    assert.equal(await findGraphics(undefined, isNamed), null);
    assert.equal(await findGraphics(null, isNamed), null);
    assert.deepEqual(await findGraphics(adapter(false), isNamed), raisedLimits);
    assert.deepEqual(await findGraphics(adapter(true), isNamed), isNamed ? raisedLimits : null);
  }
});
