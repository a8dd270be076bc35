/** Worker that decodes files, called like a function that returns a promise. */
import { BundleError } from '../bundle/error';
import type { Answer, Decoder, Request } from '../decode/messages';

/**
 * Starts a worker that answers requests in order. For each answer, `spend` is called with the milliseconds that the
 * main thread took to receive it.
 */
export function startDecoder(script: URL, spend: (milliseconds: number) => void) {
  const worker = new Worker(script, { type: 'module' });
  const pendingRequests = new Map<number, { resolve: (value: never) => void; reject: (reason: Error) => void }>();
  let lastId = 0;
  let stopError: BundleError | null = null;

  worker.onmessage = (event: MessageEvent<Answer>) => {
    const start = performance.now();
    // Browsers may deserialize a message only when its data are accessed.
    const { data } = event;
    const pending = pendingRequests.get(data.id);
    pendingRequests.delete(data.id);
    if ('error' in data) pending?.reject(new BundleError(data.error));
    else pending?.resolve(data.result as never);
    spend(performance.now() - start);
  };
  worker.onerror = (event) => {
    stopError = new BundleError(`the decoder stopped: ${event.message || 'the browser gives no reason'}`, 'other');
    for (const { reject } of pendingRequests.values()) reject(stopError);
    pendingRequests.clear();
  };

  const decode = (request: Request): Promise<never> =>
    new Promise((resolve, reject) => {
      // The worker cannot answer any more.
      if (stopError) return reject(stopError);
      const id = ++lastId;
      pendingRequests.set(id, { resolve, reject });
      worker.postMessage({ ...request, id }, buffersOf(request));
    });
  return { decode: decode as Decoder, dispose: (): void => worker.terminate() };
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
    default:
      return [];
  }
}
