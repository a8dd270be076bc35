/** Interface to the workers that read views. */
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { FromReader, ToReader, Wanted } from '../decode/reader';
import type { Failure } from '../store/error';
import { GEOMETRY, type Layout } from '../store/layout';

export interface Listener {
  view(id: number, layers: readonly Splats[]): void;
  leaf(id: number, pieces: readonly Piece[]): void;
  failed(id: number, failure: Failure): void;
  cancelled(id: number): void;
  received(bytes: number): void;
}

export interface Readers {
  read(id: number, wanted: Wanted): void;
  cancel(id: number): void;
}

/** Starts workers for the store at an address. */
export function startReaders(script: URL, count: number, base: URL, layout: Layout, listener: Listener): Readers {
  const ids = new Map<number, Worker>();
  const workers = Array.from({ length: count }, () => new Worker(script, { type: 'module' }));
  for (const worker of workers) {
    worker.onmessage = ({ data }: MessageEvent<FromReader>): void => {
      switch (data.kind) {
        case 'view':
          ids.delete(data.id);
          listener.view(data.id, data.layers);
          break;
        case 'leaf':
          ids.delete(data.id);
          listener.leaf(data.id, data.pieces);
          break;
        case 'failed':
          ids.delete(data.id);
          listener.failed(data.id, data.failure);
          break;
        case 'cancelled':
          ids.delete(data.id);
          listener.cancelled(data.id);
          break;
        case 'received':
          listener.received(data.bytes);
      }
    };
    worker.onerror = ({ message }): void => {
      const failure: Failure = {
        kind: 'other',
        message: `a worker stopped: ${message || 'the browser gives no reason'}`,
      };
      for (const [id, own] of ids) if (own === worker) listener.failed(id, failure);
    };
    send(worker, { kind: 'open', base: base.href, layout });
  }
  return {
    read(id, wanted) {
      // Views of one shard go to one worker, which reads the shard's index once; so do all leaves: they share textures.
      const group = wanted.direction === GEOMETRY ? '' : (wanted.shards[0]?.[0] ?? '');
      const worker = workers[hash(group) % workers.length] as Worker;
      ids.set(id, worker);
      send(worker, { kind: 'read', id, wanted });
    },
    cancel(id) {
      const worker = ids.get(id);
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
  for (let at = 0; at < text.length; at++) sum = Math.imul(sum ^ text.charCodeAt(at), 0x0100_0193);
  return sum >>> 0;
}
