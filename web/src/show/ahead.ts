/** Fetches files before they are asked for, so that the network does not wait for decoding and uploads. */
import type { Fetch } from '../bundle/source';

/** Bytes that are fetched ahead and not yet asked for, at most. */
const MOST_AHEAD = 16 * 2 ** 20;

export interface Ahead {
  /** The content of a file, which may be here already. */
  readonly fetch: Fetch;
  /** These files will be asked for next. */
  want(names: readonly string[], signal: AbortSignal): void;
  /** Bytes that are fetched ahead. */
  readonly bytes: number;
}

/** `sizeOf` tells the bytes of a file. */
export function createAhead(fetch: Fetch, sizeOf: (name: string) => number, most: number = MOST_AHEAD): Ahead {
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
        // Who asks for it is told.
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
