/** Prefetching of files, so that the network does not wait for decoding and uploads. */
import type { Fetch } from '../bundle/source';

/** Greatest number of prefetched bytes that are not requested yet. */
const MAX_PREFETCH_BYTES = 16 * 2 ** 20;

export interface Ahead {
  /** Returns the content of a file, possibly prefetched. */
  readonly fetch: Fetch;
  /** Prefetches files that will be requested next. */
  want(names: readonly string[], signal: AbortSignal): void;
  /** Number of prefetched bytes. */
  readonly bytes: number;
}

/** Creates the prefetcher; `sizeOf` returns the bytes of a file. */
export function createAhead(fetch: Fetch, sizeOf: (name: string) => number, most: number = MAX_PREFETCH_BYTES): Ahead {
  const held = new Map<string, Promise<ArrayBuffer>>();
  let bytes = 0;

  return {
    fetch(name, signal) {
      const found = held.get(name);
      if (!found) return fetch(name, signal);
      held.delete(name);
      bytes -= sizeOf(name);
      return found;
    },
    want(names, signal) {
      for (const name of names) {
        if (held.has(name) || bytes + sizeOf(name) > most) continue;
        const coming = fetch(name, signal);
        // A request for the file reports the error.
        coming.catch(() => undefined);
        held.set(name, coming);
        bytes += sizeOf(name);
      }
    },
    get bytes() {
      return bytes;
    },
  };
}
