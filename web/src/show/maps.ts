/** Loading of a region's maps: the map of ring 0, the changes of later rings, and full-size maps after coarse ones. */
import type { MapEntry, MapLayout, RangeScale, Sharper } from '../bundle/manifest';
import type { FileData, FirstMapRequest, MapUpdate } from '../decode/messages';
import { createCube, cubeSteps } from './cubes';
import { filesOf, type Job } from './job';
import { turnOf } from './region';

export async function loadFirstMap(job: Job, map: MapEntry): Promise<void> {
  const { manifest, region, renderer, signal, uploads } = job;
  const update = await job.maps(firstRequest(job, manifest.map, region.entry.range, await filesOf(job, map.color)));
  signal.throwIfAborted();
  await uploads.add(cubeSteps(renderer, region.cubes[0], update, 0, manifest.map), signal);
}

/** Loads a ring's changes of the previous map, or a whole map. */
export async function loadMap(job: Job, ring: number, { tiles, color, range }: MapEntry): Promise<void> {
  const { manifest, maps, number, region, renderer, signal, uploads } = job;
  const [pictures, codes] = await Promise.all([filesOf(job, color), filesOf(job, range)]);
  const isWhole = Array.isArray(color);
  const cube = region.cubes[turnOf(ring)];
  await job.mayReplace(ring);
  signal.throwIfAborted();
  if (isWhole) await maps(firstRequest(job, manifest.map, region.entry.range, pictures));
  signal.throwIfAborted();
  const since = cube.holds !== null && cube.hasRange ? cube.holds : null;
  const update = await maps({
    kind: 'next-map',
    region: number,
    // Whole ranges are encoded like those of the first ring.
    ring: isWhole ? 1 : ring,
    tiles,
    color: isWhole ? null : (pictures[0] ?? null),
    range: codes,
    since,
  });
  signal.throwIfAborted();
  await uploads.add(cubeSteps(renderer, cube, update, ring, manifest.map), signal);
}

function firstRequest(
  { number, signal }: Job,
  { face_size: faceSize, tile, across }: MapLayout,
  { step }: RangeScale,
  color: FileData[],
): FirstMapRequest {
  signal.throwIfAborted();
  return { kind: 'first-map', region: number, faceSize, tile, across, step, color };
}

/** Replaces coarse maps by full-size ones: the worker composes the last ring's map, which is then uploaded. */
export async function loadSharper(job: Job, ring: number, { layout, maps, range }: Sharper): Promise<void> {
  const { region, renderer, signal, uploads } = job;
  const [first, ...changes] = maps;
  if (!first || changes.length === 0) throw new Error('maps of full size: expected those of all rings');
  let update = await job.maps(firstRequest(job, layout, range, await filesOf(job, first.color)));
  for (const [order, change] of changes.entries()) {
    const isLast = order === changes.length - 1;
    update = await changed(job, order + 1, change, isLast);
  }
  await job.mayReplace(ring);
  signal.throwIfAborted();
  const turn = turnOf(ring);
  region.cubes[turn].dispose();
  region.cubes[turn] = createCube(renderer, layout.face_size, range);
  await uploads.add(cubeSteps(renderer, region.cubes[turn], update, ring, layout), signal);
}

/** Applies a ring's changes; the whole map is requested only for the last ring. */
async function changed(job: Job, ring: number, { tiles, color, range }: MapEntry, isLast: boolean): Promise<MapUpdate> {
  const [[picture], codes] = await Promise.all([filesOf(job, color), filesOf(job, range)]);
  job.signal.throwIfAborted();
  const since = isLast ? null : ring - 1;
  return job.maps({ kind: 'next-map', region: job.number, ring, tiles, color: picture ?? null, range: codes as FileData[], since });
}
