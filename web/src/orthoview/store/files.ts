/** Files of a store behind an address: whole ones and parts. */
import { StoreError } from './error';

export type Bytes = Uint8Array<ArrayBuffer>;

/** Milliseconds in which a file must have come. */
const LONGEST = 60_000;

/** A file or a part of it, as it lies in the store. */
export interface Asked {
  /** Path below the store. */
  readonly path: string;
  /** Tells versions of a file apart, so that no cache mixes them; empty for files that may change. */
  readonly version?: string;
  /** First byte and length; all of it by default. */
  readonly part?: readonly [number, number];
  readonly signal?: AbortSignal | undefined;
}

export interface Answered {
  readonly bytes: Bytes;
  /** The server has sent the whole file although a part was asked for. */
  readonly isWhole: boolean;
}

export interface Files {
  /** The content; null where the server has no such file. */
  read(asked: Asked): Promise<Answered | null>;
}

/** The files below an address, which ends with a slash. `receive` is told of the bytes that come. */
export function createFiles(base: URL, receive: (bytes: number) => void): Files {
  return {
    async read({ path, version = '', part, signal }) {
      const url = new URL(path, base);
      url.search = base.search;
      if (version) url.searchParams.set('v', version);
      const init: RequestInit = { signal: limited(signal) };
      // A range of one part from a first byte on: browsers ask other hosts for no permission for it.
      if (part) init.headers = { Range: `bytes=${part[0]}-${part[0] + part[1] - 1}` };
      // Documents that may have changed are asked for again.
      if (!version) init.cache = 'no-cache';
      const response = await answered(() => fetch(url, init), path, signal);
      if (response.status === 404 || response.status === 410) return null;
      if (!response.ok)
        throw new StoreError('refused', `${path}: the server answers ${response.status} ${response.statusText}`);
      const bytes: Bytes = new Uint8Array(await answered(() => response.arrayBuffer(), path, signal));
      receive(bytes.length);
      if (!part || response.status === 206) return { bytes, isWhole: !part };
      return { bytes, isWhole: true };
    },
  };
}

function limited(signal: AbortSignal | undefined): AbortSignal {
  const longest = AbortSignal.timeout(LONGEST);
  return signal ? AbortSignal.any([signal, longest]) : longest;
}

/** An error that tells of the file, but for requests that nobody wants any more. */
async function answered<T>(ask: () => Promise<T>, path: string, signal: AbortSignal | undefined): Promise<T> {
  try {
    return await ask();
  } catch (reason) {
    if (signal?.aborted) throw reason;
    const why = reason instanceof DOMException && reason.name === 'TimeoutError' ? 'is too slow' : 'does not answer';
    throw new StoreError('unreachable', `${path}: the server ${why}`);
  }
}
