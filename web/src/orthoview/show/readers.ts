/** Workers that read views and leaves. */
import type { FromReader, ToReader, ViewRequest } from '../decode/reader';
import type { Failure } from '../store/error';
import { GEOMETRY, type Layout } from '../store/layout';

export type Readers = ReturnType<typeof startReaders>;

/** Starts workers for the store at a base address; `receive` is called with their messages. */
export function startReaders(
  script: URL,
  count: number,
  base: URL,
  layout: Layout,
  receive: (message: FromReader) => void,
) {
  const workerOfRequest = new Map<number, Worker>();
  const workers = Array.from({ length: count }, () => new Worker(script, { type: 'module' }));
  for (const worker of workers) {
    worker.onmessage = ({ data }: MessageEvent<FromReader>): void => {
      if ('id' in data) workerOfRequest.delete(data.id);
      receive(data);
    };
    worker.onerror = ({ message }): void => {
      const reason = message || 'the browser gives no reason';
      const failure: Failure = { kind: 'other', message: `a worker stopped: ${reason}` };
      for (const [id, owner] of workerOfRequest) if (owner === worker) receive({ kind: 'failed', id, failure });
    };
    send(worker, { kind: 'open', base: base.href, layout });
  }
  return {
    read(id: number, request: ViewRequest): void {
      // The views of a shard go to one worker, because some servers send whole shards. All leaves go to one worker,
      // because they share textures.
      const group = request.direction === GEOMETRY ? '' : (request.files[0]?.[0] ?? '');
      const worker = workers[hash(group) % workers.length] as Worker;
      workerOfRequest.set(id, worker);
      send(worker, { kind: 'read', id, request });
    },
    cancel(id: number): void {
      const worker = workerOfRequest.get(id);
      if (worker) send(worker, { kind: 'cancel', id });
    },
  };
}

function send(worker: Worker, message: ToReader): void {
  worker.postMessage(message);
}

/** FNV-1a hash. */
function hash(text: string): number {
  let sum = 0x811c_9dc5;
  for (let index = 0; index < text.length; index++) sum = Math.imul(sum ^ text.charCodeAt(index), 0x0100_0193);
  return sum >>> 0;
}
