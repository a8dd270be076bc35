/** Shares simultaneous requests for the same file; limits the number of simultaneous jobs. */
import { abortable } from '../base/errors';

type ByteListener = (bytes: number) => void;
type Load = (name: string, signal: AbortSignal, onBytes: ByteListener) => Promise<ArrayBuffer>;

interface Request {
  readonly result: Promise<ArrayBuffer>;
  readonly controller: AbortController;
  readonly listeners: Set<ByteListener>;
  receivedBytes: number;
}

/** Shares requests: each caller gets a copy of the data and all progress; the last caller's abort ends the request. */
export function shareRequests(load: Load): Load {
  const pending = new Map<string, Request>();

  function begin(name: string): Request {
    const controller = new AbortController();
    const listeners = new Set<ByteListener>();
    const request: Request = {
      listeners,
      controller,
      receivedBytes: 0,
      result: Promise.resolve().then(() =>
        load(name, controller.signal, (bytes) => {
          request.receivedBytes += bytes;
          for (const listener of listeners) listener(bytes);
        }),
      ),
    };
    pending.set(name, request);
    const remove = (): void => {
      if (pending.get(name) === request) pending.delete(name);
    };
    request.result.then(remove, remove);
    return request;
  }

  return async (name, signal, onBytes) => {
    signal.throwIfAborted();
    const request = pending.get(name) ?? begin(name);
    const isFirst = request.listeners.size === 0;
    // A new function for each caller: the set would merge equal ones.
    const listener: ByteListener = (bytes) => onBytes(bytes);
    request.listeners.add(listener);
    if (request.receivedBytes > 0) listener(request.receivedBytes);
    const leave = (): void => {
      request.listeners.delete(listener);
      if (request.listeners.size > 0) return;
      // Later callers get a new request.
      if (pending.get(name) === request) pending.delete(name);
      request.controller.abort(signal.reason);
    };
    return abortable<ArrayBuffer>(signal, (fulfil, fail) => {
      // Copied before the first caller can transfer its buffer.
      request.result.then((data) => fulfil(isFirst ? data : data.slice(0)), fail);
      return leave;
    });
  };
}

/** Runs a job when a slot is free. */
export type Slots = <T>(signal: AbortSignal, job: () => Promise<T>) => Promise<T>;

export function createSlots(slotCount: number): Slots {
  let freeSlots = slotCount;
  const waiting = new Set<() => void>();

  return async (signal, job) => {
    signal.throwIfAborted();
    if (freeSlots > 0) freeSlots -= 1;
    else {
      await abortable<void>(signal, (enter) => {
        waiting.add(enter);
        return () => waiting.delete(enter);
      });
    }
    try {
      return await job();
    } finally {
      const [next] = waiting;
      if (next) {
        waiting.delete(next);
        next();
      } else freeSlots += 1;
    }
  };
}
