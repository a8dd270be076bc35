/** Promise-based interface to a decoder worker. */
import { BundleError } from '../bundle/error';
import type {
  Answer,
  DropRequest,
  FirstMapRequest,
  ForgetRequest,
  Geometry,
  GeometryRequest,
  Kept,
  MapUpdate,
  NextMapRequest,
  Part,
  PartRequest,
  Request,
} from '../decode/messages';

export interface Decoder {
  (request: GeometryRequest): Promise<Geometry>;
  (request: PartRequest): Promise<Part>;
  (request: DropRequest): Promise<null>;
  (request: FirstMapRequest | NextMapRequest): Promise<MapUpdate>;
  (request: ForgetRequest): Promise<Kept>;
}

export interface DecoderWorker {
  readonly decode: Decoder;
  dispose(): void;
}

/** Starts a worker that answers requests in order; `spend` is called with the milliseconds spent on answers. */
export function startDecoder(script: URL, spend: (milliseconds: number) => void): DecoderWorker {
  const worker = new Worker(script, { type: 'module' });
  const waiting = new Map<number, { done: (value: never) => void; failed: (reason: Error) => void }>();
  let last = 0;
  let stopped: BundleError | null = null;

  worker.onmessage = (event: MessageEvent<Answer>) => {
    const start = performance.now();
    // Browsers may deserialize a message only when its data are accessed.
    const { data } = event;
    const pending = waiting.get(data.id);
    waiting.delete(data.id);
    if ('error' in data) pending?.failed(new BundleError(data.error));
    else pending?.done(data.result as never);
    spend(performance.now() - start);
  };
  worker.onerror = (event) => {
    stopped = new BundleError(`the decoder stopped: ${event.message || 'the browser gives no reason'}`, 'other');
    for (const { failed } of waiting.values()) failed(stopped);
    waiting.clear();
  };

  const decode = (request: Request): Promise<never> =>
    new Promise((done, failed) => {
      // The worker cannot answer any more.
      if (stopped) {
        failed(stopped);
        return;
      }
      const id = ++last;
      waiting.set(id, { done, failed });
      worker.postMessage({ ...request, id }, buffersOf(request));
    });
  return { decode: decode as Decoder, dispose: () => worker.terminate() };
}

/** Returns the buffers to transfer with a request: the contents of its files. */
function buffersOf(request: Request): ArrayBuffer[] {
  switch (request.kind) {
    case 'geometry':
      return [request.glb, ...request.parts].flatMap(({ data }) => data ?? []);
    case 'first-map':
      return request.color.map((file) => file.data);
    case 'next-map':
      return [...(request.color ? [request.color] : []), ...request.range].map((file) => file.data);
    case 'part':
    case 'drop':
    case 'forget':
      return [];
  }
}
