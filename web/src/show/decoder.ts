/** A worker that decodes, as a function. */
import { BundleError } from '../bundle/error';
import type {
  Answer,
  FirstMapRequest,
  ForgetRequest,
  Geometry,
  GeometryRequest,
  Kept,
  MapUpdate,
  NextMapRequest,
  Request,
} from '../decode/messages';

export interface Decoder {
  (request: GeometryRequest): Promise<Geometry>;
  (request: FirstMapRequest | NextMapRequest): Promise<MapUpdate>;
  (request: ForgetRequest): Promise<Kept>;
}

export interface Worked {
  readonly decode: Decoder;
  dispose(): void;
}

/** Start a worker; requests are answered in their order. */
export function startDecoder(script: URL): Worked {
  const worker = new Worker(script, { type: 'module' });
  const waiting = new Map<number, { done: (value: never) => void; failed: (reason: Error) => void }>();
  let last = 0;
  let stopped: BundleError | null = null;

  worker.onmessage = ({ data }: MessageEvent<Answer>) => {
    const asked = waiting.get(data.id);
    waiting.delete(data.id);
    if ('error' in data) asked?.failed(new BundleError(data.error));
    else asked?.done(data.result as never);
  };
  worker.onerror = (event) => {
    stopped = new BundleError(`the decoder stopped: ${event.message || 'the browser gives no reason'}`, 'other');
    for (const { failed } of waiting.values()) failed(stopped);
    waiting.clear();
  };

  const decode = (request: Request): Promise<never> =>
    new Promise((done, failed) => {
      // Nobody would answer.
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

/** Buffers that are transferred with a request: the contents of its files. */
function buffersOf(request: Request): ArrayBuffer[] {
  switch (request.kind) {
    case 'geometry':
      return [request.glb, ...request.parts].map((file) => file.data);
    case 'first-map':
      return request.color.map((file) => file.data);
    case 'next-map':
      return [...(request.color ? [request.color] : []), ...request.range].map((file) => file.data);
    case 'forget':
      return [];
  }
}
