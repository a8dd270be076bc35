/** One transfer of a file. It is given up when the server sends nothing for a while. */
import { BundleError } from './error';

/** Seconds without a byte after which a transfer is given up; up to twice as long may pass. */
const STALLED = 10;
/** Answers after which it is of use to ask again, besides those from 500 on: too slow, too early, too many. */
const LATER = new Set([408, 425, 429]);

/** Waiting and fetching, so that tests need not wait. */
export interface Network {
  /** `again` is true after a transfer that failed: a copy in the browser's cache is not trusted then. */
  readonly fetch: (url: URL, signal: AbortSignal, again: boolean) => Promise<Response>;
  /** Rejects with the signal's reason when it is aborted. */
  readonly wait: (seconds: number, signal: AbortSignal) => Promise<void>;
}

export const NETWORK: Network = {
  fetch: (url, signal, again) =>
    fetch(url, { signal, credentials: 'same-origin', cache: again ? 'reload' : 'default' }),
  wait: (seconds, signal) =>
    new Promise((done, failed) => {
      signal.throwIfAborted();
      const stop = (): void => {
        clearTimeout(timer);
        failed(signal.reason as Error);
      };
      const timer = setTimeout(() => {
        signal.removeEventListener('abort', stop);
        done();
      }, 1000 * seconds);
      signal.addEventListener('abort', stop, { once: true });
    }),
};

export interface Limits {
  readonly name: string;
  /** Size, bytes; null where it is not known. */
  readonly bytes: number | null;
  /** Greatest size, bytes. */
  readonly most: number;
}

/** Fetch a file once: BundleError where asking again is of no use, any other error where it may be. */
export async function transfer(
  url: URL,
  limits: Limits,
  received: (bytes: number) => void,
  signal: AbortSignal,
  again: boolean,
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
  let size = 0;
  try {
    const response = await network.fetch(url, end, again);
    refuse(limits.name, response);
    const parts: Uint8Array<ArrayBuffer>[] = [];
    for (const reader = response.body?.getReader(); reader; ) {
      const { done, value } = await reader.read();
      if (done) break;
      isMoving = true;
      parts.push(value as Uint8Array<ArrayBuffer>);
      size += value.length;
      received(value.length);
      if (size > limits.most) throw wrongSize(limits, 'more');
    }
    // Servers that break off without a length look as if they were ready.
    if (limits.bytes !== null && size < limits.bytes) throw new Error(`expected ${limits.bytes} bytes, got ${size}`);
    return await new Blob(parts).arrayBuffer();
  } catch (error) {
    received(-size);
    throw error;
  } finally {
    stop.abort(new Error('over'));
  }
}

function refuse(name: string, { ok, status, statusText }: Response): void {
  if (ok) return;
  const answer = `the server answers ${status} ${statusText}`.trim();
  if (status >= 500 || LATER.has(status)) throw new Error(answer);
  throw new BundleError(`${name}: ${answer}`, 'network');
}

function wrongSize({ name, bytes, most }: Limits, got: string): BundleError {
  const expected = bytes === null ? `at most ${most} bytes` : `${bytes} bytes, as the manifest lists it`;
  return new BundleError(`${name}: expected ${expected}, got ${got}`);
}
