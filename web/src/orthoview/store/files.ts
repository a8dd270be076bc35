/** Files of a store at an address: whole files and byte ranges. */
import { StoreError } from './error';

export type Bytes = Uint8Array<ArrayBuffer>;

/** Timeout of a request, milliseconds. */
const REQUEST_TIMEOUT = 60_000;

const MISSING = 'the store refers to this file, and the server does not have it';

/** File or byte range, as stored. */
export interface FileRequest {
  /** Path below the store. */
  readonly path: string;
  /** Version of a file's content as a cache key; empty for files that may change. */
  readonly version?: string;
  /** Offset of the first byte, and number of bytes; the whole file by default. */
  readonly part?: readonly [number, number];
  readonly signal?: AbortSignal | undefined;
  /** Message if the server has no such file. */
  readonly missing?: string;
}

export type Files = ReturnType<typeof createFiles>;

/** Creates access to files below an address, which ends with a slash. `receive` is called with received bytes. */
export function createFiles(base: URL, receive: (bytes: number) => void) {
  return {
    async read({ path, version = '', part, signal, missing = MISSING }: FileRequest) {
      const url = new URL(path, base);
      url.search = base.search;
      if (version) url.searchParams.set('v', version);
      const init: RequestInit = { signal: withTimeout(signal) };
      // A single range that states its first byte needs no CORS preflight request.
      if (part) init.headers = { Range: `bytes=${part[0]}-${part[0] + part[1] - 1}` };
      // Documents that may have changed are revalidated.
      if (!version) init.cache = 'no-cache';
      const response = await withFileName(() => fetch(url, init), path, signal);
      if (response.status === 404 || response.status === 410) throw new StoreError('gone', `${path}: ${missing}`);
      if (!response.ok)
        throw new StoreError('refused', `${path}: the server answers ${response.status} ${response.statusText}`);
      const bytes: Bytes = new Uint8Array(await withFileName(() => response.arrayBuffer(), path, signal));
      receive(bytes.length);
      // Servers without range requests send the whole file although a range was requested.
      return { bytes, isWhole: !part || response.status !== 206 };
    },
  };
}

function withTimeout(signal: AbortSignal | undefined): AbortSignal {
  const timeout = AbortSignal.timeout(REQUEST_TIMEOUT);
  return signal ? AbortSignal.any([signal, timeout]) : timeout;
}

/** Throws errors that name the file; errors of aborted requests remain unchanged. */
async function withFileName<T>(request: () => Promise<T>, path: string, signal: AbortSignal | undefined): Promise<T> {
  try {
    return await request();
  } catch (reason) {
    if (signal?.aborted) throw reason;
    const problem = (reason as Error).name === 'TimeoutError' ? 'is too slow' : 'does not answer';
    throw new StoreError('unreachable', `${path}: the server ${problem}`);
  }
}
