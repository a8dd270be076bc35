/** Fetches the files of a bundle, one request per file, with retries after stalled or broken transfers. */
import { messageOf } from '../base/errors';
import { BundleError } from './error';
import type { FileEntry, Manifest } from './manifest';
import { createSlots, shareRequests } from './requests';
import { NETWORK, type Network, transfer } from './transfer';

/** Pauses before each retry, seconds. */
const PAUSES = [0.5, 1, 2, 4] as const;
/** Greatest number of concurrent transfers. */
const MAX_TRANSFERS = 6;
/** Name of the document that a page loads first. */
const DOCUMENT = 'manifest.json';
/** Greatest size of a manifest, bytes; a thousand regions take a fifth of it. */
export const MAX_MANIFEST = 64 * 2 ** 20;

/** Receives the number of new bytes; negative when a transfer breaks and its bytes no longer count. */
export type Received = (bytes: number) => void;

/** Fetches files of a bundle and checks their size. */
export type Fetch = (name: string, signal: AbortSignal, received?: Received) => Promise<ArrayBuffer>;

/** Fetches a file from the server. */
export type Serve = (name: string, signal: AbortSignal, received: Received) => Promise<ArrayBuffer>;

/** Fetches a file from elsewhere, or from the server by `serve`. */
export type Route = (...request: [...Parameters<Serve>, serve: Serve]) => Promise<ArrayBuffer>;

export interface Files {
  /**
   * Fetches a file and checks that it has the listed size. Simultaneous callers share one request, and each gets a
   * copy. Files are fetched in the order of the requests, several at a time.
   */
  readonly fetch: Fetch;
  /** Reports a damaged file, so that the next fetch bypasses the browser's cache. */
  readonly distrust: (name: string) => void;
  /** Manifest entry of a file; undefined for unlisted files. */
  readonly entryOf: (name: string) => FileEntry | undefined;
  /** Sets another way to fetch files; null for the server only. */
  readonly setRoute: (route: Route | null) => void;
}

export interface Source extends Pick<Files, 'fetch' | 'distrust'> {
  readonly manifest: Manifest;
}

/** Fetches the document that a page loads first, from a base URL. */
export async function readDocument(base: URL, received: Received, signal: AbortSignal, network = NETWORK) {
  const limits = { name: DOCUMENT, bytes: null, maxBytes: MAX_MANIFEST };
  const content = await withRetries(`${DOCUMENT} cannot be loaded`, signal, network, (isRetry) =>
    transfer(new URL(DOCUMENT, base), limits, received, signal, isRetry, network),
  );
  return new TextDecoder().decode(content);
}

/** Fetches listed files by `load`, at most `atOnce` of them at a time; throws an error for unlisted files. */
export function serveListed(
  entryOf: Files['entryOf'],
  atOnce: number,
  load: (name: string, bytes: number, signal: AbortSignal, received: Received) => Promise<ArrayBuffer>,
): Serve {
  const slots = createSlots(atOnce);
  return async (name, signal, received) => {
    const bytes = entryOf(name)?.bytes;
    if (bytes === undefined) throw new BundleError(`${name}: the manifest does not list this file`);
    return slots(signal, () => load(name, bytes, signal, received));
  };
}

/** Fetches listed files below a base URL; `received` gets the bytes of all files. */
export function createFiles(
  base: URL,
  entryOf: Files['entryOf'],
  received: Received,
  network: Network = NETWORK,
): Files {
  const distrusted = new Set<string>();
  let route: Route | null = null;

  const serve = serveListed(entryOf, MAX_TRANSFERS, (name, bytes, signal, onBytes) =>
    withRetries(`${name} cannot be loaded`, signal, network, (isRetry) => {
      const mustReload = distrusted.delete(name) || isRetry;
      return transfer(new URL(name, base), { name, bytes, maxBytes: bytes }, onBytes, signal, mustReload, network);
    }),
  );

  const shared = shareRequests((name, signal, onBytes) => {
    const report: Received = (bytes) => {
      received(bytes);
      onBytes(bytes);
    };
    return route ? route(name, signal, report, serve) : serve(name, signal, report);
  });
  return {
    fetch: (name, signal, onBytes = () => undefined) => shared(name, signal, onBytes),
    distrust: (name) => distrusted.add(name),
    entryOf,
    setRoute: (next) => (route = next),
  };
}

/**
 * Repeats an attempt until it succeeds or throws a BundleError; the error after the last attempt begins with `failure`.
 */
export async function withRetries<T>(
  failure: string,
  signal: AbortSignal,
  network: Network,
  attempt: (isRetry: boolean) => Promise<T>,
): Promise<T> {
  for (let number = 0; ; number++) {
    signal.throwIfAborted();
    try {
      return await attempt(number > 0);
    } catch (error) {
      // A definite response of the server does not change on retry.
      if (signal.aborted || error instanceof BundleError) throw error;
      const pause = PAUSES[number];
      if (pause === undefined) throw new BundleError(`${failure}: ${messageOf(error)}`, 'network');
      await network.wait(pause, signal);
    }
  }
}
