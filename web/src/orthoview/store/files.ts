/** Reads whole files and byte ranges of a store at a base address. */
import { StoreError } from './error';

export type Bytes = Uint8Array<ArrayBuffer>;

/** Timeout of a request, milliseconds. */
const REQUEST_TIMEOUT = 60_000;

const MISSING = 'the store refers to this file, but the server does not have it';

/** Request for a file or a byte range. */
export interface FileRequest {
  /** Path below the store. */
  readonly path: string;
  /** Version of the content, a key for caches; empty for files that may change. */
  readonly version?: string;
  /** Offset of the first byte, and number of bytes; the whole file by default. */
  readonly part?: readonly [number, number];
  readonly signal?: AbortSignal | undefined;
  /** Message if the server has no such file. */
  readonly missing?: string;
}

export type Files = ReturnType<typeof createFiles>;

/** Creates a reader of files below an address that ends with a slash; `receive` gets the number of received bytes. */
export function createFiles(base: URL, receive: (bytes: number) => void) {
  return {
    async read({ path, version = '', part, signal, missing = MISSING }: FileRequest) {
      const url = new URL(path, base);
      url.search = base.search;
      if (version) url.searchParams.set('v', version);
      const init: RequestInit = { signal: withTimeout(signal) };
      // Browsers send a single range with a first byte without a CORS preflight request.
      if (part) init.headers = { Range: `bytes=${part[0]}-${part[0] + part[1] - 1}` };
      // Files without a version may have changed, so caches must revalidate them.
      if (!version) init.cache = 'no-cache';
      const response = await withFileName(() => fetch(url, init), path, signal);
      if (response.status === 404 || response.status === 410) throw new StoreError('gone', `${path}: ${missing}`);
      if (!response.ok)
        throw new StoreError('refused', `${path}: the server answers ${response.status} ${response.statusText}`);
      const bytes: Bytes = new Uint8Array(await withFileName(() => response.arrayBuffer(), path, signal));
      receive(bytes.length);
      // A server that ignores ranges sends the whole file.
      return { bytes, isWhole: !part || response.status !== 206 };
    },
  };
}

function withTimeout(signal: AbortSignal | undefined): AbortSignal {
  const timeout = AbortSignal.timeout(REQUEST_TIMEOUT);
  return signal ? AbortSignal.any([signal, timeout]) : timeout;
}

/** Converts errors to ones that name the file; errors of aborted requests stay unchanged. */
async function withFileName<T>(request: () => Promise<T>, path: string, signal: AbortSignal | undefined): Promise<T> {
  try {
    return await request();
  } catch (reason) {
    if (signal?.aborted) throw reason;
    const problem = (reason as Error).name === 'TimeoutError' ? 'is too slow' : 'does not answer';
    throw new StoreError('unreachable', `${path}: the server ${problem}`);
  }
}
