/** Requests: one for all who ask for the same thing at the same time, and a limited number at once. */
import { abortable } from '../base/errors';

type Received = (bytes: number) => void;
type Load = (name: string, signal: AbortSignal, received: Received) => Promise<ArrayBuffer>;

interface Request {
  readonly result: Promise<ArrayBuffer>;
  readonly stop: AbortController;
  readonly listeners: Set<Received>;
  /** Bytes received so far. */
  size: number;
}

/**
 * Shares the requests of a function. Each asker gets its own copy of the data and all progress; a request is aborted
 * when its last asker leaves.
 */
export function createShared(load: Load): Load {
  const open = new Map<string, Request>();

  function begin(name: string): Request {
    const stop = new AbortController();
    const listeners = new Set<Received>();
    const request: Request = {
      listeners,
      stop,
      size: 0,
      result: Promise.resolve().then(() =>
        load(name, stop.signal, (bytes) => {
          request.size += bytes;
          for (const received of listeners) received(bytes);
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

  return async (name, signal, received) => {
    signal.throwIfAborted();
    const request = open.get(name) ?? begin(name);
    const isFirst = request.listeners.size === 0;
    // Wrapped, so that a function passed by several askers counts once for each.
    const own: Received = (bytes) => received(bytes);
    request.listeners.add(own);
    if (request.size > 0) own(request.size);
    const leave = (): void => {
      request.listeners.delete(own);
      if (request.listeners.size > 0) return;
      // Later askers get a new request.
      if (open.get(name) === request) open.delete(name);
      request.stop.abort(signal.reason);
    };
    return abortable<ArrayBuffer>(signal, (done, failed) => {
      // Copied before the first asker can transfer its buffer.
      request.result.then((data) => done(isFirst ? data : data.slice(0)), failed);
      return leave;
    });
  };
}

export type Slots = <T>(signal: AbortSignal, job: () => Promise<T>) => Promise<T>;

export function createSlots(number: number): Slots {
  let free = number;
  const waiting = new Set<() => void>();

  function place(signal: AbortSignal): Promise<void> {
    return abortable<void>(signal, (enter) => {
      waiting.add(enter);
      return () => waiting.delete(enter);
    });
  }

  return async (signal, job) => {
    signal.throwIfAborted();
    if (free === 0) await place(signal);
    else free -= 1;
    try {
      return await job();
    } finally {
      const [next] = waiting;
      if (next) {
        waiting.delete(next);
        next();
      } else {
        free += 1;
      }
    }
  };
}
