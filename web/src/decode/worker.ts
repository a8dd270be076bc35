/** Worker that decodes geometry and maps, one request after another. */
import { messageOf } from '../base/errors';
import { bandsOf } from './files';
import { type Buffers, decodeGeometry } from './geometry';
import { createMaps, type Maps } from './maps';
import type { Answer, Job, Part, Result } from './messages';
import { transferablesOf, packIntoParts, samplesOf } from './pieces';
import { FOLDER } from './surfaces';

/** Maps by region. */
const maps = new Map<number, Maps>();
const buffers: Buffers = new Map();
/** Parts of geometry that the page has not requested yet, by the id of the job. */
const partsOfJobs = new Map<number, Part[]>();
let lastAnswer = Promise.resolve();

self.onmessage = ({ data: job }: MessageEvent<Job>): void => {
  // Parts are decoded already and need not wait for other jobs.
  if (job.kind === 'part' || job.kind === 'drop') void answer(job);
  else lastAnswer = lastAnswer.then(() => answer(job));
};

async function answer(job: Job): Promise<void> {
  try {
    const result = await work(job);
    post({ id: job.id, result }, buffersOf(result));
  } catch (error) {
    post({ id: job.id, error: messageOf(error) }, []);
  }
}

async function work(job: Job): Promise<Result> {
  switch (job.kind) {
    case 'geometry': {
      const { pieces, images, triangles } = await decodeGeometry(job, buffers);
      const parts = packIntoParts(await bandsOf(images), pieces);
      partsOfJobs.set(job.id, parts);
      return { number: job.id, parts: parts.length, samples: samplesOf(pieces), triangles };
    }
    case 'part': {
      const parts = partsOfJobs.get(job.geometry);
      const part = parts?.[job.part];
      if (!parts || !part) throw new Error(`geometry ${job.geometry} has no part ${job.part}`);
      if (job.part === parts.length - 1) partsOfJobs.delete(job.geometry);
      return part;
    }
    case 'drop':
      for (const { bitmap } of partsOfJobs.get(job.geometry)?.flatMap(({ bands }) => bands) ?? []) bitmap.close();
      partsOfJobs.delete(job.geometry);
      return null;
    case 'first-map': {
      const regionMaps = createMaps();
      maps.set(job.region, regionMaps);
      return regionMaps.decodeFirst(job);
    }
    case 'next-map':
      // New maps reject a ring before the first map.
      return (maps.get(job.region) ?? createMaps()).decodeNext(job);
    case 'forget': {
      for (const name of job.buffers) buffers.delete(name.slice(FOLDER.length));
      maps.delete(job.region);
      const bytes = [...buffers.values()].reduce((sum, { byteLength }) => sum + byteLength, 0);
      return { buffers: buffers.size, bytes, maps: maps.size };
    }
  }
}

function post(message: Answer, transfer: Transferable[]): void {
  self.postMessage(message, { transfer });
}

/** Buffers to transfer with a result. */
function buffersOf(result: Result): Transferable[] {
  if (!result || 'buffers' in result || 'parts' in result) return [];
  if ('pieces' in result) return transferablesOf(result);
  const arrays = result.whole ? [...result.color, ...(result.codes ?? [])] : [result.tiles, result.color, result.codes];
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
