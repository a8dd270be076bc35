/** Loads a region ring by ring, in order; each is shown when all of it is on the GPU. */
import type { WebGLRenderer } from 'three';
import { filesOfRing } from '../bundle/contents';
import type { Described, Manifest, MapEntry } from '../bundle/manifest';
import type { Received } from '../bundle/source';
import type { FileData, FirstMapRequest } from '../decode/messages';
import { type Ahead, createAhead } from './ahead';
import { cubeSteps } from './cubes';
import type { Decoder } from './decoder';
import type { Shared } from './materials';
import type { PieceMesh } from './pieces';
import type { Programs } from './programs';
import { receiveParts } from './receive';
import type { Region } from './region';
import type { Store } from './store';
import type { Uploads } from './uploads';

/** Fetches files of the bundle, checked for their size. */
export type Fetch = (name: string, signal: AbortSignal, received?: Received) => Promise<ArrayBuffer>;

export interface Loading {
  readonly manifest: Manifest;
  readonly renderer: WebGLRenderer;
  readonly shared: Shared;
  readonly store: Store;
  readonly uploads: Uploads;
  /** Workers for geometry, and for maps: the latter keeps the state of each region's maps. */
  readonly geometry: Decoder;
  readonly maps: Decoder;
  readonly fetch: Fetch;
  readonly programs: Programs;
  readonly warm: (meshes: readonly PieceMesh[]) => void;
}

/** The loading of one region. */
export interface Course {
  readonly region: Region;
  /** Number of the region. */
  readonly number: number;
  /** Is told of each ring that can be shown. */
  readonly arrived: (ring: number) => void;
  /** Is told of the bytes that come, and of those of files that are here. */
  readonly received: Received;
  /** Resolves when it is this region's turn. */
  readonly turn: (signal: AbortSignal) => Promise<void>;
  /** Wait until the cube that holds an older map may be overwritten: it is shown while a cross-fade lasts. */
  readonly mayReplace: (ring: number) => Promise<void>;
  readonly signal: AbortSignal;
}

interface Job extends Loading, Course {
  readonly ahead: Ahead;
  /** Names of parts that the region has asked for, or had from other regions. */
  readonly had: Set<string>;
}

/** Load all rings; while one is decoded and uploaded, files of the next one are fetched. */
export async function loadRegion(loading: Loading, course: Course): Promise<void> {
  const { number, region, received, signal, turn } = course;
  const { manifest } = loading;
  const sizeOf = (name: string): number => manifest.files[name]?.bytes ?? 0;
  const fetch: Fetch = (name, own) => loading.fetch(name, own, received);
  const job: Job = { ...loading, ...course, ahead: createAhead(fetch, sizeOf), had: new Set() };
  const { rings } = region.entry;
  await turn(signal);
  if (rings[0]?.map) await loadFirstMap(job, rings[0].map);
  course.arrived(0);
  const { dynamic } = manifest;
  if (dynamic) await loadGeometry(job, 0, dynamic.geometry, dynamic.parts);
  for (let ring = 1; ring < rings.length; ring++) {
    const described = rings[ring];
    if (!described) throw new Error(`region ${number} has no ring ${ring}`);
    await turn(signal);
    const jobs: Promise<void>[] = [];
    if (described.map) jobs.push(loadMap(job, ring, described.map));
    if (described.geometry !== null) jobs.push(loadGeometry(job, ring, described.geometry, described.parts));
    // After those of this ring.
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
    // From another region.
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

async function loadFirstMap(job: Job, map: MapEntry): Promise<void> {
  const { manifest, region, renderer, signal, uploads } = job;
  const update = await job.maps(firstRequest(job, await filesOf(job, map.color)));
  signal.throwIfAborted();
  await uploads.add(cubeSteps(renderer, region.cubes[0], update, 0, manifest.map), signal);
}

/** Load what a ring changes of the map before it, or a whole map. */
async function loadMap(job: Job, ring: number, { tiles, color, range }: MapEntry): Promise<void> {
  const { manifest, maps, number, region, renderer, signal, uploads } = job;
  const [pictures, codes] = await Promise.all([filesOf(job, color), filesOf(job, range)]);
  const isWhole = Array.isArray(color);
  const cube = region.cubes[ring % 2 === 0 ? 0 : 1];
  await job.mayReplace(ring);
  signal.throwIfAborted();
  if (isWhole) await maps(firstRequest(job, pictures));
  signal.throwIfAborted();
  const since = cube.holds !== null && cube.hasRange ? cube.holds : null;
  const update = await maps({
    kind: 'next-map',
    region: number,
    // Whole ranges come as those of the first ring do.
    ring: isWhole ? 1 : ring,
    tiles,
    color: isWhole ? null : (pictures[0] ?? null),
    range: codes,
    since,
  });
  signal.throwIfAborted();
  await uploads.add(cubeSteps(renderer, cube, update, ring, manifest.map), signal);
}

function firstRequest({ manifest, number, region, signal }: Job, color: FileData[]): FirstMapRequest {
  signal.throwIfAborted();
  const { face_size: faceSize, tile, across } = manifest.map;
  return { kind: 'first-map', region: number, faceSize, tile, across, step: region.entry.range.step, color };
}

function filesOf(job: Job, names: string | readonly string[] | null): Promise<FileData[]> {
  const list = names === null ? [] : typeof names === 'string' ? [names] : names;
  return Promise.all(list.map((name) => fileOf(job, name)));
}

async function fileOf({ ahead, manifest, signal }: Job, name: string): Promise<FileData> {
  const described: Described | undefined = manifest.files[name];
  if (!described) throw new Error(`${name} is not listed in the manifest`);
  return { name, data: await ahead.fetch(name, signal), bytes: described.bytes, sha256: described.sha256 };
}
