/** Worker that decodes geometry and maps, one request after the other. */
import { messageOf } from '../base/errors';
import { bandsOf } from './files';
import { type Buffers, decodeGeometry } from './geometry';
import { createMaps, type Maps } from './maps';
import type {
  Answer,
  ForgetRequest,
  Geometry,
  GeometryRequest,
  Job,
  WorkerMemory,
  Part,
  PartRequest,
  Result,
} from './messages';
import { contentsOf, packIntoParts, samplesOf } from './pieces';
import { FOLDER } from './surfaces';

/** Maps by region. */
const maps = new Map<number, Maps>();
const buffers: Buffers = new Map();
/** Parts of geometry that the page has not requested yet, by the number of their job. */
const parcels = new Map<number, Part[]>();
let last = Promise.resolve();

self.onmessage = ({ data: job }: MessageEvent<Job>): void => {
  // Parts are ready and need not wait for running decodes.
  if (job.kind === 'part' || job.kind === 'drop') void answer(job);
  else last = last.then(() => answer(job));
};

async function answer(job: Job): Promise<void> {
  try {
    const result = await work(job);
    post({ id: job.id, result }, transferred(result));
  } catch (error) {
    post({ id: job.id, error: messageOf(error) }, []);
  }
}

async function work(job: Job): Promise<Result> {
  switch (job.kind) {
    case 'geometry':
      return geometry(job);
    case 'part':
      return part(job);
    case 'drop':
      for (const { rows } of parcels.get(job.of)?.flatMap(({ bands }) => bands) ?? []) rows.close();
      parcels.delete(job.of);
      return null;
    case 'first-map':
      maps.set(job.region, createMaps());
      return mapsOf(job.region).first(job);
    case 'next-map':
      return mapsOf(job.region).next(job);
    case 'forget':
      return forget(job);
  }
}

async function geometry(job: GeometryRequest & { readonly id: number }): Promise<Geometry> {
  const { pieces, images, triangles } = await decodeGeometry(job, buffers);
  const parts = packIntoParts(await bandsOf(images), pieces);
  parcels.set(job.id, parts);
  return { number: job.id, parts: parts.length, samples: samplesOf(pieces), triangles };
}

function part({ of, part: number }: PartRequest): Part {
  const parts = parcels.get(of);
  const found = parts?.[number];
  if (!parts || !found) throw new Error(`geometry ${of} has no part ${number}`);
  if (number === parts.length - 1) parcels.delete(of);
  return found;
}

function mapsOf(region: number): Maps {
  const found = maps.get(region);
  if (!found) throw new Error('map: a ring was requested before the first map');
  return found;
}

function forget({ buffers: names, region }: ForgetRequest): WorkerMemory {
  for (const name of names) buffers.delete(name.slice(FOLDER.length));
  maps.delete(region);
  const sizes = [...buffers.values()].map(({ byteLength }) => byteLength);
  return { buffers: sizes.length, bytes: sizes.reduce((sum, size) => sum + size, 0), maps: maps.size };
}

function post(answered: Answer, transfer: Transferable[]): void {
  self.postMessage(answered, { transfer });
}

function transferred(result: Result): Transferable[] {
  if (!result || 'buffers' in result || 'parts' in result) return [];
  if ('pieces' in result) return contentsOf(result);
  const arrays = result.whole ? [...result.color, ...(result.codes ?? [])] : [result.tiles, result.color, result.codes];
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
