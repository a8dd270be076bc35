/** Fetches the files of a bundle: one request for each, again if a transfer stalls or breaks off. */
import { BundleError } from './error';
import type { Described, Manifest } from './manifest';
import { parseManifest } from './parse';
import { createShared } from './share';
import { createSlots } from './slots';
import { type Network, NETWORK, transfer } from './transfer';

/** Seconds before each new trial of a transfer. */
const PAUSES = [0.5, 1, 2, 4] as const;
/** Files that are fetched at the same time. */
const AT_ONCE = 6;
/** The document by which a page begins. */
const DOCUMENT = 'manifest.json';
/** Greatest size of a manifest, bytes: a thousand regions take a fifth of it. */
export const MOST_MANIFEST = 64 * 2 ** 20;

/** Is told how many bytes came; of a broken transfer, which begins anew, how many of them count no longer (below 0). */
export type Received = (bytes: number) => void;

/** Fetches files of a bundle, checked for their size. */
export type Fetch = (name: string, signal: AbortSignal, received?: Received) => Promise<ArrayBuffer>;

/** Asks the server for a file. */
export type Serve = (name: string, signal: AbortSignal, received: Received) => Promise<ArrayBuffer>;

/** Comes by a file, from elsewhere or from the server. */
export type Way = (...request: [...Parameters<Serve>, serve: Serve]) => Promise<ArrayBuffer>;

export interface Files {
  /**
   * The content of a file, as long as the manifest says. One request serves all who ask for a file at the same time;
   * each gets bytes of its own. Files come in the order in which they are asked for, some at the same time.
   */
  readonly fetch: Fetch;
  /** A file was damaged: the next time it is not taken from the browser's cache. */
  readonly distrust: (name: string) => void;
  /** A file as the manifest lists it; undefined of one that it does not list. */
  readonly described: (name: string) => Described | undefined;
  /** Come by files another way from now on; null for that of the server alone. */
  readonly goBy: (way: Way | null) => void;
}

export interface Source extends Pick<Files, 'fetch' | 'distrust'> {
  readonly manifest: Manifest;
}

/** The document by which a page begins, from below a base URL. */
export async function readDocument(
  base: URL,
  received: Received,
  signal: AbortSignal,
  network: Network = NETWORK,
): Promise<string> {
  const limits = { name: DOCUMENT, bytes: null, most: MOST_MANIFEST };
  const content = await withTrials(DOCUMENT, signal, network, (again) =>
    transfer(new URL(DOCUMENT, base), limits, received, signal, again, network),
  );
  return new TextDecoder().decode(content);
}

/** Files below a base URL, which a manifest lists; `received` is told of the bytes of all. */
export function createFiles(
  base: URL,
  described: Files['described'],
  received: Received,
  network: Network = NETWORK,
): Files {
  const distrusted = new Set<string>();
  const slots = createSlots(AT_ONCE);
  let way: Way | null = null;

  const serve: Serve = async (name, own, told) => {
    const bytes = described(name)?.bytes;
    if (bytes === undefined) throw new BundleError(`${name}: the manifest does not list this file`);
    return slots(own, () =>
      withTrials(name, own, network, (again) => {
        const isRenewed = distrusted.delete(name) || again;
        return transfer(new URL(name, base), { name, bytes, most: bytes }, told, own, isRenewed, network);
      }),
    );
  };

  const shared = createShared((name, own, told) => {
    const both: Received = (more) => {
      received(more);
      told(more);
    };
    return way ? way(name, own, both, serve) : serve(name, own, both);
  });
  return {
    fetch: (name, own, told = () => undefined) => shared(name, own, told),
    distrust: (name) => distrusted.add(name),
    described,
    goBy: (next) => (way = next),
  };
}

/** Open a bundle whose manifest lies below a base URL; `received` is told of the bytes of all files. */
export async function openSource(
  base: URL,
  received: Received,
  signal: AbortSignal,
  network: Network = NETWORK,
): Promise<Source> {
  const manifest = parseManifest(await readDocument(base, received, signal, network));
  return { manifest, ...createFiles(base, (name) => manifest.files[name], received, network) };
}

export async function withTrials<T>(
  name: string,
  signal: AbortSignal,
  network: Network,
  trial: (again: boolean) => Promise<T>,
): Promise<T> {
  for (let number = 0; ; number++) {
    signal.throwIfAborted();
    try {
      return await trial(number > 0);
    } catch (error) {
      // A server's definite answer does not change by asking again.
      if (signal.aborted || error instanceof BundleError) throw error;
      const pause = PAUSES[number];
      const reason = error instanceof Error ? error.message : String(error);
      if (pause === undefined) throw new BundleError(`${name} does not come: ${reason}`, 'network');
      await network.wait(pause, signal);
    }
  }
}
