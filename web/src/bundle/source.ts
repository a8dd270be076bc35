/** Fetches the files of a bundle: one request for each, again if a transfer stalls or breaks off. */
import { BundleError } from './error';
import type { Manifest } from './manifest';
import { parseManifest } from './parse';

/** Seconds without a byte after which a transfer is given up, and before each new trial. */
const STALLED = 10;
const PAUSES = [0.5, 1, 2, 4] as const;
/** Files that are fetched at the same time. */
const AT_ONCE = 6;

/** Waiting and fetching, so that tests need not wait. */
export interface Network {
  readonly fetch: (url: URL, signal: AbortSignal) => Promise<Response>;
  readonly wait: (seconds: number, signal: AbortSignal) => Promise<void>;
}

export const NETWORK: Network = {
  fetch: (url, signal) => fetch(url, { signal, credentials: 'omit' }),
  wait: (seconds, signal) =>
    new Promise((done, failed) => {
      const timer = setTimeout(done, 1000 * seconds);
      signal.addEventListener('abort', () => {
        clearTimeout(timer);
        failed(signal.reason as Error);
      }, { once: true });
    }),
};

export interface Source {
  readonly manifest: Manifest;
  /** The content of a file. Files that are being fetched for another one are not fetched twice. */
  readonly fetch: (name: string, signal: AbortSignal) => Promise<ArrayBuffer>;
}

/** Open a bundle whose manifest lies below a base URL; `received` is told of every byte that comes. */
export async function openSource(
  base: URL,
  received: (bytes: number) => void,
  signal: AbortSignal,
  network: Network = NETWORK,
): Promise<Source> {
  const load = (name: string, own: AbortSignal): Promise<ArrayBuffer> =>
    withTrials(name, own, network, () => transfer(new URL(name, base), name, received, own, network));
  const manifest = parseManifest(new TextDecoder().decode(await load('manifest.json', signal)));
  const slots = createSlots(AT_ONCE);
  return {
    manifest,
    fetch: (name, own) => slots(() => {
      own.throwIfAborted();
      return load(name, own);
    }),
  };
}

/** Runs so many jobs at once, in the order in which they come. */
function createSlots(number: number): <T>(job: () => Promise<T>) => Promise<T> {
  let free = number;
  const waiting: (() => void)[] = [];
  return async (job) => {
    if (free === 0) await new Promise<void>((done) => waiting.push(done));
    else free -= 1;
    try {
      return await job();
    } finally {
      const next = waiting.shift();
      if (next) next();
      else free += 1;
    }
  };
}

async function withTrials<T>(name: string, signal: AbortSignal, network: Network, trial: () => Promise<T>): Promise<T> {
  for (const pause of [...PAUSES, null]) {
    try {
      return await trial();
    } catch (error) {
      // What the server says for certain does not change by asking again.
      if (signal.aborted || error instanceof BundleError) throw error;
      const reason = error instanceof Error ? error.message : String(error);
      if (pause === null) throw new BundleError(`${name} does not come: ${reason}`);
      await network.wait(pause, signal);
    }
  }
  throw new BundleError(`${name} does not come`);
}

async function transfer(
  url: URL,
  name: string,
  received: (bytes: number) => void,
  signal: AbortSignal,
  network: Network,
): Promise<ArrayBuffer> {
  const stop = new AbortController();
  const end = AbortSignal.any([signal, stop.signal]);
  let isMoving = true;
  const watch = async (): Promise<void> => {
    while (isMoving) {
      isMoving = false;
      await network.wait(STALLED, end);
    }
    stop.abort(new Error(`the server sends nothing for ${STALLED} s`));
  };
  // It ends when the transfer does.
  watch().catch(() => undefined);
  try {
    const response = await network.fetch(url, end);
    if (!response.ok) {
      const error = `${name}: the server answers ${response.status} ${response.statusText}`.trim();
      throw response.status >= 500 ? new Error(error) : new BundleError(error);
    }
    const parts: Uint8Array<ArrayBuffer>[] = [];
    for (const reader = response.body?.getReader(); reader; ) {
      const { done, value } = await reader.read();
      if (done) break;
      isMoving = true;
      parts.push(value as Uint8Array<ArrayBuffer>);
      received(value.length);
    }
    return await new Blob(parts).arrayBuffer();
  } finally {
    stop.abort(new Error('over'));
  }
}
