/** Shares one request between all who ask for the same thing at the same time. */

type Told = (bytes: number) => void;
type Ask = (name: string, signal: AbortSignal, told: Told) => Promise<ArrayBuffer>;

interface Request {
  readonly result: Promise<ArrayBuffer>;
  readonly stop: AbortController;
  readonly askers: Set<Told>;
  /** Bytes received so far. */
  size: number;
}

/**
 * Shares the requests of a function. Each asker gets its own copy of the data and all progress; a request is aborted
 * when its last asker leaves.
 */
export function createShared(ask: Ask): Ask {
  const open = new Map<string, Request>();

  function begin(name: string): Request {
    const stop = new AbortController();
    const askers = new Set<Told>();
    const request: Request = {
      askers,
      stop,
      size: 0,
      result: Promise.resolve().then(() =>
        ask(name, stop.signal, (bytes) => {
          request.size += bytes;
          for (const told of askers) told(bytes);
        }),
      ),
    };
    open.set(name, request);
    const forget = (): void => {
      if (open.get(name) === request) open.delete(name);
    };
    request.result.then(forget, forget);
    return request;
  }

  return async (name, signal, told) => {
    signal.throwIfAborted();
    const request = open.get(name) ?? begin(name);
    const isFirst = request.askers.size === 0;
    // Wrapped, so that a function passed by several askers counts once for each.
    const own: Told = (bytes) => told(bytes);
    request.askers.add(own);
    if (request.size > 0) own(request.size);
    const leave = (): void => {
      request.askers.delete(own);
      if (request.askers.size > 0) return;
      // Later askers get a new request.
      if (open.get(name) === request) open.delete(name);
      request.stop.abort(signal.reason);
    };
    return new Promise<ArrayBuffer>((done, failed) => {
      const stopped = (): void => {
        leave();
        failed(signal.reason as Error);
      };
      signal.addEventListener('abort', stopped, { once: true });
      // Copied before the first asker can transfer its buffer.
      const copied = (data: ArrayBuffer): void => done(isFirst ? data : data.slice(0));
      request.result.then(copied, failed).finally(() => signal.removeEventListener('abort', stopped));
    });
  };
}
