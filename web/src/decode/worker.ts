/** A worker that decodes geometry and maps, one request after the other. */
import { reasonOf } from './files';
import { type Buffers, decodeGeometry } from './geometry';
import { createMaps } from './maps';
import type { Answer, Geometry, Job, MapUpdate } from './messages';

const maps = createMaps();
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

function work(job: Job): Promise<Geometry | MapUpdate> {
  switch (job.kind) {
    case 'geometry':
      return decodeGeometry(job, buffers);
    case 'first-map':
      return maps.first(job);
    case 'next-map':
      return maps.next(job);
  }
}

function post(answered: Answer, transfer: Transferable[]): void {
  self.postMessage(answered, { transfer });
}

function transferred(result: Geometry | MapUpdate): Transferable[] {
  if ('pieces' in result) {
    const arrays = result.pieces.flatMap(({ positions, normals, uvs, colors, indices, placements }) =>
      [positions, normals, uvs, colors, indices, placements].filter((array) => array !== null),
    );
    return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer)), ...Object.values(result.images)];
  }
  const arrays = result.whole ? [...result.color, ...(result.codes ?? [])] : [result.tiles, result.color, result.codes];
  return [...new Set(arrays.map((array) => array.buffer as ArrayBuffer))];
}
