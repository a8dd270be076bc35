/** Fetches the files of a bundle: one request for each, again if a transfer stalls or breaks off. */
import { BundleError } from './error';
import type { Manifest } from './manifest';
import { parseManifest } from './parse';
import { createShared } from './share';
import { createSlots } from './slots';
import { type Network, NETWORK, transfer } from './transfer';

/** Seconds before each new trial of a transfer. */
const PAUSES = [0.5, 1, 2, 4] as const;
/** Files that are fetched at the same time. */
const AT_ONCE = 6;
/** Greatest size of a manifest, bytes: a thousand regions take a fifth of it. */
const MOST_MANIFEST = 64 * 2 ** 20;

/** Is told how many bytes came; of a broken transfer, which begins anew, how many of them count no longer (below 0). */
export type Received = (bytes: number) => void;

export interface Source {
  readonly manifest: Manifest;
  /**
   * The content of a file, as long as the manifest says. One request serves all who ask for a file at the same time;
   * each gets bytes of its own. Files come in the order in which they are asked for, some at the same time.
   */
  readonly fetch: (name: string, signal: AbortSignal, received?: Received) => Promise<ArrayBuffer>;
  /** A file was damaged: the next time it is not taken from the browser's cache. */
  readonly distrust: (name: string) => void;
}

/** Open a bundle whose manifest lies below a base URL; `received` is told of the bytes of all files. */
export async function openSource(
  base: URL,
  received: Received,
  signal: AbortSignal,
  network: Network = NETWORK,
): Promise<Source> {
  const distrusted = new Set<string>();
  /** `bytes` is the size of the file, where it is known, and `most` the greatest that it may have. */
  const load = (name: string, bytes: number | null, most: number, own: AbortSignal, told: Received) => {
    const limits = { name, bytes, most };
    return withTrials(name, own, network, (again) => {
      const isRenewed = distrusted.delete(name) || again;
      return transfer(new URL(name, base), limits, told, own, isRenewed, network);
    });
  };
  const text = await load('manifest.json', null, MOST_MANIFEST, signal, received);
  const manifest = parseManifest(new TextDecoder().decode(text));
  const slots = createSlots(AT_ONCE);
  const shared = createShared((name: string, own, told) => {
    const bytes = manifest.files[name]?.bytes;
    if (bytes === undefined) throw new BundleError(`${name}: the manifest does not list this file`);
    return slots(own, () => load(name, bytes, bytes, own, (more) => {
      received(more);
      told(more);
    }));
  });
  return {
    manifest,
    fetch: (name, own, told = () => undefined) => shared(name, own, told),
    distrust: (name) => distrusted.add(name),
  };
}

async function withTrials<T>(
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
