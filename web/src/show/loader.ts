/** Loads a region ring by ring, in order; each is shown when all of it is on the GPU. */
import type { WebGLRenderer } from 'three';
import type { Described, Manifest } from '../bundle/manifest';
import type { FileData } from '../decode/messages';
import { cubeSteps } from './cubes';
import type { Decoder } from './decoder';
import type { Shared } from './materials';
import type { PieceMesh } from './pieces';
import { geometrySteps, type Region } from './region';
import type { Uploads } from './uploads';

/** Fetches files of the bundle, checked for their size. */
export type Fetch = (name: string, signal: AbortSignal) => Promise<ArrayBuffer>;

export interface Loading {
  readonly manifest: Manifest;
  readonly renderer: WebGLRenderer;
  readonly shared: Shared;
  readonly uploads: Uploads;
  /** Workers for geometry, and for maps: a region keeps the state of its maps in the latter. */
  readonly geometry: Decoder;
  readonly maps: Decoder;
  readonly fetch: Fetch;
  /** Number of the last ring that is loaded. */
  readonly last: number;
  /** Names of the buffers that the worker for geometry has. */
  readonly sent: Set<string>;
  readonly warm: (mesh: PieceMesh) => void;
}

/** Wait until the cube that holds an older map may be overwritten: it is shown while a cross-fade lasts. */
export type MayReplace = (ring: number) => Promise<void>;

/** Load all rings; `arrived` is told of each that can be shown. */
export async function loadRegion(
  loading: Loading,
  region: Region,
  arrived: (ring: number) => void,
  mayReplace: MayReplace,
  signal: AbortSignal,
): Promise<void> {
  const { entry } = region;
  await loadFirstMap(loading, region, signal);
  arrived(0);
  const { dynamic } = loading.manifest;
  if (dynamic) await loadGeometry(loading, region, 0, dynamic.geometry, dynamic.parts, signal);
  for (let ring = 1; ring < entry.rings.length && ring <= loading.last; ring++) {
    const described = entry.rings[ring];
    if (!described) continue;
    const jobs = [loadNextMap(loading, region, ring, mayReplace, signal)];
    if (described.geometry !== null) {
      jobs.push(loadGeometry(loading, region, ring, described.geometry, described.parts, signal));
    }
    await Promise.all(jobs);
    arrived(ring);
  }
}

async function loadGeometry(
  loading: Loading,
  region: Region,
  ring: number,
  name: string,
  partNames: readonly string[],
  signal: AbortSignal,
): Promise<void> {
  const wanted = partNames.filter((part) => !region.textures.has(part) && !loading.sent.has(part));
  const [glb, ...parts] = await Promise.all([name, ...wanted].map((file) => fileOf(loading, file, signal)));
  if (!glb) throw new Error(`${name} is not there`);
  const geometry = await loading.geometry({
    kind: 'geometry',
    glb,
    parts,
    known: [...region.textures.keys()],
    center: region.entry.center,
    isDynamic: ring === 0,
  });
  for (const part of wanted) {
    if (part.endsWith('.bin')) loading.sent.add(part);
  }
  signal.throwIfAborted();
  const steps = geometrySteps(loading.renderer, region, ring, geometry, loading.shared, loading.warm);
  await loading.uploads.add(steps, signal);
}

async function loadFirstMap(loading: Loading, region: Region, signal: AbortSignal): Promise<void> {
  const { manifest, maps, renderer, uploads } = loading;
  const { map, range } = { map: manifest.map, range: region.entry.range };
  const color = await filesOf(loading, region.entry.rings[0]?.map.color ?? null, signal);
  const update = await maps({
    kind: 'first-map',
    faceSize: map.face_size,
    tile: map.tile,
    across: map.across,
    step: range.step,
    color,
  });
  signal.throwIfAborted();
  await uploads.add(cubeSteps(renderer, region.cubes[0], update, 0, map), signal);
}

async function loadNextMap(
  loading: Loading,
  region: Region,
  ring: number,
  mayReplace: MayReplace,
  signal: AbortSignal,
): Promise<void> {
  const described = region.entry.rings[ring]?.map;
  if (!described) return;
  const [color, range] = await Promise.all([
    filesOf(loading, described.color, signal),
    filesOf(loading, described.range, signal),
  ]);
  const cube = region.cubes[ring % 2 === 0 ? 0 : 1];
  await mayReplace(ring);
  signal.throwIfAborted();
  const since = cube.holds !== null && cube.hasRange ? cube.holds : null;
  const update = await loading.maps({
    kind: 'next-map',
    ring,
    tiles: described.tiles,
    color: color[0] ?? null,
    range,
    since,
  });
  signal.throwIfAborted();
  await loading.uploads.add(cubeSteps(loading.renderer, cube, update, ring, loading.manifest.map), signal);
}

function filesOf(loading: Loading, names: string | readonly string[] | null, signal: AbortSignal): Promise<FileData[]> {
  const list = names === null ? [] : typeof names === 'string' ? [names] : names;
  return Promise.all(list.map((name) => fileOf(loading, name, signal)));
}

async function fileOf(loading: Loading, name: string, signal: AbortSignal): Promise<FileData> {
  const described: Described | undefined = loading.manifest.files[name];
  if (!described) throw new Error(`${name} is not listed in the manifest`);
  const data = await loading.fetch(name, signal);
  return { name, data, bytes: described.bytes, sha256: described.sha256 };
}
