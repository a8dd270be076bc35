/** Worker that reads and decodes views. */
import { failureOf } from '../store/error';
import { GEOMETRY } from '../store/layout';
import { buffersOf } from './leaf';
import { createReader, type FromReader, type Reader, type ToReader, type ViewRequest } from './reader';

let reader: Reader | null = null;
/** Abort controllers of the running reads, by the number of the request. */
const running = new Map<number, AbortController>();

self.onmessage = ({ data }: MessageEvent<ToReader>): void => {
  switch (data.kind) {
    case 'open':
      reader = createReader(new URL(data.base), data.layout, (bytes) => post({ kind: 'received', bytes }));
      break;
    case 'read':
      void read(data.id, data.request);
      break;
    case 'cancel':
      running.get(data.id)?.abort();
  }
};

async function read(id: number, request: ViewRequest): Promise<void> {
  if (!reader) return;
  const control = new AbortController();
  running.set(id, control);
  try {
    if (request.direction === GEOMETRY) {
      const pieces = await reader.leaf(request, control.signal);
      post({ kind: 'leaf', id, pieces }, buffersOf(pieces));
    } else {
      const layers = await reader.read(request, control.signal);
      post({ kind: 'view', id, layers }, layers.map(({ words }) => words.buffer));
    }
  } catch (reason) {
    if (control.signal.aborted) post({ kind: 'cancelled', id });
    else post({ kind: 'failed', id, failure: failureOf(reason) });
  } finally {
    running.delete(id);
  }
}

function post(message: FromReader, transfer: Transferable[] = []): void {
  self.postMessage(message, { transfer });
}
