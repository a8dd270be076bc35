/** Loads the maps and the geometry of a region, ring by ring. A ring can be shown when all of it is on the GPU. */
import type { Texture, WebGLRenderer } from 'three';
import { filesOfRing } from '../bundle/contents';
import type { Manifest, MapEntry, MapLayout, RangeScale, RingEntry, SharperMaps } from '../bundle/manifest';
import type { Fetch, Received } from '../bundle/source';
import type { Decoder, FileData, FirstMapRequest, Geometry, NextMapRequest } from '../decode/messages';
import type { Store } from './buffers';
import type { Shared } from './materials';
import type { PieceMesh } from './pieces';
import type { Programs } from './programs';
import { cubeIndexOf, partSteps, type Region, showRing } from './region';
import { copyTexture, createCube, createPictures, cubeSteps } from './textures';
import type { Uploads } from './uploads';

export interface Loading {
  readonly renderer: WebGLRenderer;
  readonly shared: Shared;
  readonly store: Store;
  readonly uploads: Uploads;
  /** Worker for geometry, and worker for maps, which keeps the last map of each region. */
  readonly geometry: Decoder;
  readonly maps: Decoder;
  readonly fetch: Fetch;
  readonly programs: Programs;
  readonly warmUp: (meshes: readonly PieceMesh[]) => void;
}

/** Loading of one region. */
export interface RegionLoading {
  /** Manifest of the region's bundle. */
  readonly manifest: Manifest;
  readonly region: Region;
  readonly number: number;
  /** Called with the number of each ring that can be shown from then on. */
  readonly onRing: (ring: number) => void;
  /** Called with a number of bytes when they arrive, or when a file was already loaded for another region. */
  readonly onBytes: Received;
  /** Waits until the server has a ring and it is this region's turn; returns the ring. */
  readonly waitForRing: (ring: number) => Promise<RingEntry>;
  /** Waits until the cube for a ring's map is free: a cross-fade still shows the older map in it. */
  readonly waitForCube: (ring: number) => Promise<void>;
  readonly signal: AbortSignal;
}

interface Job extends Loading, RegionLoading {
  readonly prefetch: ReturnType<typeof createPrefetch>;
  /** Names of the parts that this region has requested or found already loaded. */
  readonly requested: Set<string>;
}

/** Loads all rings. While a ring is decoded and uploaded, files of the next one are prefetched. */
export async function loadRegion(loading: Loading, regionLoading: RegionLoading): Promise<void> {
  const { manifest, region, onBytes, signal, waitForRing } = regionLoading;
  const sizeOf = (name: string): number => manifest.files[name]?.bytes ?? 0;
  const fetch: Fetch = (name, own) => loading.fetch(name, own, onBytes);
  const job: Job = { ...loading, ...regionLoading, prefetch: createPrefetch(fetch, sizeOf), requested: new Set() };
  const { rings } = region.entry;
  const { map } = await waitForRing(0);
  if (map) {
    const pictures = await filesOf(job, map.color);
    const update = await job.maps(firstRequest(job, manifest.map, region.entry.range, pictures));
    signal.throwIfAborted();
    await job.uploads.add(cubeSteps(job.renderer, region.cubes[0], update, 0, manifest.map), signal);
  }
  regionLoading.onRing(0);
  const { dynamic } = manifest;
  if (dynamic) await loadGeometry(job, 0, dynamic.geometry, dynamic.parts);
  for (let ring = 1; ring < rings.length; ring++) {
    const entry = await waitForRing(ring);
    const jobs: Promise<void>[] = [];
    if (entry.map) jobs.push(loadMap(job, ring, entry.map));
    if (entry.sharper) jobs.push(loadSharperMap(job, ring, entry.sharper));
    if (entry.geometry !== null) jobs.push(loadGeometry(job, ring, entry.geometry, entry.parts));
    // The files of the next ring are requested after those of this one.
    const next = rings[ring + 1];
    const isNew = (name: string): boolean => !isLoaded(loading, name) && !job.requested.has(name);
    if (next) job.prefetch.begin(filesOfRing(next).filter(isNew), signal);
    await Promise.all(jobs);
    regionLoading.onRing(ring);
  }
}

/** Whether a file's content is on the GPU or in the worker. */
function isLoaded({ store }: Loading, name: string): boolean {
  return store.textures.has(name) || store.buffers.has(name);
}

async function loadGeometry(job: Job, ring: number, name: string, partNames: readonly string[]): Promise<void> {
  const { manifest, region, signal, store } = job;
  const missing = partNames.filter((part) => !isLoaded(job, part));
  for (const part of partNames) {
    // The part was loaded for another region.
    if (isLoaded(job, part) && !job.requested.has(part)) job.onBytes(manifest.files[part]?.bytes ?? 0);
    job.requested.add(part);
  }
  const isInWorker = store.buffers.has(name);
  if (isInWorker) job.onBytes(manifest.files[name]?.bytes ?? 0);
  const [glb, ...parts] = await Promise.all([
    isInWorker ? ({ name, data: null } as const) : fileOf(job, name),
    ...missing.map((file) => fileOf(job, file)),
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
  for (const part of missing) if (part.endsWith('.bin')) store.buffers.add(part);
  if (ring === 0) store.buffers.add(name);
  await uploadParts(job, ring, geometry);
}

/** Loads the map of a ring: its changes to the previous map, or a whole map. */
async function loadMap(job: Job, ring: number, { tiles, color, range }: MapEntry): Promise<void> {
  const { manifest, maps, region, renderer, signal, uploads } = job;
  const [pictures, codes] = await Promise.all([filesOf(job, color), filesOf(job, range)]);
  const isWhole = Array.isArray(color);
  const cube = region.cubes[cubeIndexOf(ring)];
  await job.waitForCube(ring);
  signal.throwIfAborted();
  if (isWhole) await maps(firstRequest(job, manifest.map, region.entry.range, pictures));
  signal.throwIfAborted();
  const fromRing = cube.ringShown !== null && cube.hasRange ? cube.ringShown : null;
  // The ranges of a whole map are encoded like those of ring 1.
  const update = await maps(nextRequest(job, isWhole ? 1 : ring, tiles, isWhole ? [] : pictures, codes, fromRing));
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

function nextRequest(
  { number, signal }: Job,
  ring: number,
  tiles: readonly number[],
  pictures: readonly FileData[],
  range: readonly FileData[],
  since: number | null,
): NextMapRequest {
  signal.throwIfAborted();
  return { kind: 'next-map', region: number, ring, tiles, color: pictures[0] ?? null, range, since };
}

/** Replaces a coarse map by the last ring's full-size map, which the worker composes from the maps of all rings. */
async function loadSharperMap(job: Job, ring: number, { layout, maps, range }: SharperMaps): Promise<void> {
  const { region, renderer, signal, uploads } = job;
  const [first, ...changes] = maps;
  if (!first || changes.length === 0) throw new Error('full-size maps: expected one for each ring');
  let update = await job.maps(firstRequest(job, layout, range, await filesOf(job, first.color)));
  for (const [order, { tiles, color, range: codeNames }] of changes.entries()) {
    const [pictures, codes] = await Promise.all([filesOf(job, color), filesOf(job, codeNames)]);
    // Only after the last change, the worker returns the whole map.
    const since = order === changes.length - 1 ? null : order;
    update = await job.maps(nextRequest(job, order + 1, tiles, pictures, codes, since));
  }
  await job.waitForCube(ring);
  signal.throwIfAborted();
  const index = cubeIndexOf(ring);
  region.cubes[index].dispose();
  region.cubes[index] = createCube(renderer, layout.face_size, range);
  await uploads.add(cubeSteps(renderer, region.cubes[index], update, ring, layout), signal);
}

/** Uploads the parts of a ring's geometry while the worker decodes them, and shows the ring when it is complete. */
async function uploadParts(job: Job, ring: number, { number, parts, samples, triangles }: Geometry): Promise<void> {
  const { renderer, region, store, uploads, geometry, programs, signal, warmUp } = job;
  const copy = (texture: Texture): Texture => copyTexture(renderer, texture);
  const resources = { gl: renderer.getContext() as WebGL2RenderingContext, store, copy, warmUp };
  const pictures = createPictures(renderer, (name, texture) => {
    // Another region may have loaded the same texture meanwhile.
    if (store.textures.has(name)) texture.dispose();
    else store.textures.set(name, texture);
  });
  try {
    signal.throwIfAborted();
    await programs.compileFor(samples);
    let before = Promise.resolve();
    for (let next = 0; next < parts; next++) {
      const part = await geometry({ kind: 'part', geometry: number, part: next });
      const sent = uploads.add(partSteps(region, ring, part, resources, pictures), signal);
      // The error is thrown where the promise is awaited.
      sent.catch(() => undefined);
      await before;
      before = sent;
    }
    await before;
    showRing(region, ring, triangles);
  } finally {
    pictures.dispose();
    // The error of a stopped worker is reported to its pending requests.
    geometry({ kind: 'drop', geometry: number }).catch(() => undefined);
  }
}

function filesOf(job: Job, names: string | readonly string[] | null): Promise<FileData[]> {
  return Promise.all([names ?? []].flat().map((name) => fileOf(job, name)));
}

async function fileOf({ prefetch, manifest, signal }: Job, name: string): Promise<FileData> {
  const entry = manifest.files[name];
  if (!entry) throw new Error(`${name} is not listed in the manifest`);
  return { name, data: await prefetch.fetch(name, signal), bytes: entry.bytes, sha256: entry.sha256 };
}

/** Greatest number of bytes of the files that are prefetched and not used yet. */
const MAX_PREFETCH_BYTES = 16 * 2 ** 20;

/** Fetches files before they are used, so that the network is busy during decoding; `sizeOf` returns a file's bytes. */
export function createPrefetch(fetch: Fetch, sizeOf: (name: string) => number, maxBytes = MAX_PREFETCH_BYTES) {
  const prefetched = new Map<string, Promise<ArrayBuffer>>();
  let bytes = 0;

  return {
    /** Returns the content of a file: from the prefetched files, or from the network. */
    fetch(name: string, signal: AbortSignal): Promise<ArrayBuffer> {
      const content = prefetched.get(name);
      if (!content) return fetch(name, signal);
      prefetched.delete(name);
      bytes -= sizeOf(name);
      return content;
    },
    /** Begins to fetch files that will be used next, as long as they fit into the limit. */
    begin(names: readonly string[], signal: AbortSignal): void {
      for (const name of names) {
        if (prefetched.has(name) || bytes + sizeOf(name) > maxBytes) continue;
        const content = fetch(name, signal);
        // The error is thrown where the file is used.
        content.catch(() => undefined);
        prefetched.set(name, content);
        bytes += sizeOf(name);
      }
    },
    /** Bytes of the prefetched files that are not used yet. */
    get bytes(): number {
      return bytes;
    },
  };
}
