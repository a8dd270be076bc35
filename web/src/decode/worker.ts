/** A worker that decodes geometry and maps, one request after the other. */
import { reasonOf } from './files';
import { type Buffers, decodeGeometry } from './geometry';
import { createMaps, type Maps } from './maps';
import type { Answer, ForgetRequest, Geometry, Job, Kept, MapUpdate } from './messages';
import { FOLDER } from './surfaces';

/** By region. */
const maps = new Map<number, Maps>();
const buffers: Buffers = new Map();
let last = Promise.resolve();

self.onmessage = ({ data: job }: MessageEvent<Job>): void => {
  last = last.then(() => answer(job));
};

async function answer(job: Job): Promise<void> {
  try {
    const result = await work(job);
    post({ id: job.id, result }, transferred(result));
  } catch (error) {
    post({ id: job.id, error: reasonOf(error) }, []);
  }
}

async function work(job: Job): Promise<Geometry | MapUpdate | Kept> {
  switch (job.kind) {
    case 'geometry':
      return decodeGeometry(job, buffers);
    case 'first-map':
      maps.set(job.region, createMaps());
      return mapsOf(job.region).first(job);
    case 'next-map':
      return mapsOf(job.region).next(job);
    case 'forget':
      return forget(job);
  }
}

function mapsOf(region: number): Maps {
  const found = maps.get(region);
  if (!found) throw new Error('map: a ring came before the first map');
  return found;
}

function forget({ buffers: names, region }: ForgetRequest): Kept {
  for (const name of names) buffers.delete(name.slice(FOLDER.length));
  maps.delete(region);
  const sizes = [...buffers.values()].map(({ byteLength }) => byteLength);
  return { buffers: sizes.length, bytes: sizes.reduce((sum, size) => sum + size, 0), maps: maps.size };
}

function post(answered: Answer, transfer: Transferable[]): void {
  self.postMessage(answered, { transfer });
}

function transferred(result: Geometry | MapUpdate | Kept): Transferable[] {
  if ('buffers' in result) return [];
  if ('pieces' in result) {
    const arrays = result.pieces.flatMap(({ positions, normals, uvs, colors, indices, placements }) =>
      [positions, normals, uvs, colors, indices, placements].filter((array) => array !== null),
    );
    return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer)), ...Object.values(result.images)];
  }
  const arrays = result.whole ? [...result.color, ...(result.codes ?? [])] : [result.tiles, result.color, result.codes];
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
