/** Loading of a region ring by ring; each ring is shown when all of it is on the GPU. */
import { filesOfRing } from '../bundle/contents';
import type { Fetch } from '../bundle/source';
import { createAhead } from './ahead';
import { type Course, fileOf, type Job, type Loading } from './job';
import { loadFirstMap, loadMap, loadSharper } from './maps';
import { receiveParts } from './receive';

/** Loads all rings; while one is decoded and uploaded, files of the next one are prefetched. */
export async function loadRegion(loading: Loading, course: Course): Promise<void> {
  const { manifest, region, received, signal, turn } = course;
  const sizeOf = (name: string): number => manifest.files[name]?.bytes ?? 0;
  const fetch: Fetch = (name, own) => loading.fetch(name, own, received);
  const job: Job = { ...loading, ...course, ahead: createAhead(fetch, sizeOf), had: new Set() };
  const { rings } = region.entry;
  const { map } = await turn(0, signal);
  if (map) await loadFirstMap(job, map);
  course.arrived(0);
  const { dynamic } = manifest;
  if (dynamic) await loadGeometry(job, 0, dynamic.geometry, dynamic.parts);
  for (let ring = 1; ring < rings.length; ring++) {
    const described = await turn(ring, signal);
    const jobs: Promise<void>[] = [];
    if (described.map) jobs.push(loadMap(job, ring, described.map));
    if (described.sharper) jobs.push(loadSharper(job, ring, described.sharper));
    if (described.geometry !== null) jobs.push(loadGeometry(job, ring, described.geometry, described.parts));
    // Requested after the files of this ring.
    const next = rings[ring + 1];
    const isNew = (name: string): boolean => !isHere(loading, name) && !job.had.has(name);
    if (next) job.ahead.want(filesOfRing(next).filter(isNew), signal);
    await Promise.all(jobs);
    course.arrived(ring);
  }
}

/** Whether a file's content is on the GPU or in the worker. */
function isHere({ store }: Loading, name: string): boolean {
  return store.textures.has(name) || store.buffers.has(name);
}

async function loadGeometry(job: Job, ring: number, name: string, partNames: readonly string[]): Promise<void> {
  const { manifest, region, signal, store } = job;
  const wanted = partNames.filter((part) => !isHere(job, part));
  for (const part of partNames) {
    // Loaded for another region.
    if (isHere(job, part) && !job.had.has(part)) job.received(manifest.files[part]?.bytes ?? 0);
    job.had.add(part);
  }
  const isKept = store.buffers.has(name);
  if (isKept) job.received(manifest.files[name]?.bytes ?? 0);
  const [glb, ...parts] = await Promise.all([
    isKept ? ({ name, data: null } as const) : fileOf(job, name),
    ...wanted.map((file) => fileOf(job, file)),
  ]);
  signal.throwIfAborted();
  const geometry = await job.geometry({
    kind: 'geometry',
    glb,
    parts,
    known: [...store.textures.keys()],
    center: region.entry.center,
    growth: {
      radii: region.entry.rings.slice(1).map(({ radius }) => radius),
      nearShare: manifest.morph.near_share,
      reach: manifest.growth.reach,
    },
    isDynamic: ring === 0,
  });
  for (const part of wanted) {
    if (part.endsWith('.bin')) store.buffers.add(part);
  }
  if (ring === 0) store.buffers.add(name);
  await receiveParts(job, region, ring, geometry, signal);
}
