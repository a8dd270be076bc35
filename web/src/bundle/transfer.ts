/** A single transfer of a file, aborted when the server sends nothing for a while. */
import { chunksOf } from '../base/bytes';
import { abortable } from '../base/errors';
import { BundleError } from './error';

/** A transfer is aborted if no byte arrives during one of these intervals, seconds. */
const STALL_SECONDS = 10;
/** Status codes below 500 that make a retry worthwhile: timeout, too early, too many requests. */
const RETRY_STATUSES = new Set([408, 425, 429]);

/** Fetch function and timer, which tests replace. */
export interface Network {
  /** `isRetry` is true after a failed transfer: the browser's cached copy is not trusted. */
  readonly fetch: (url: URL, signal: AbortSignal, isRetry: boolean) => Promise<Response>;
  /** Rejects with the signal's reason when it is aborted. */
  readonly wait: (seconds: number, signal: AbortSignal) => Promise<void>;
}

export const NETWORK: Network = {
  fetch: (url, signal, isRetry) =>
    fetch(url, { signal, credentials: 'same-origin', cache: isRetry ? 'reload' : 'default' }),
  wait: (seconds, signal) =>
    abortable<void>(signal, (done) => {
      const timer = setTimeout(done, 1000 * seconds);
      return () => clearTimeout(timer);
    }),
};

export interface Limits {
  readonly name: string;
  /** Size, bytes; null if unknown. */
  readonly bytes: number | null;
  /** Greatest size, bytes. */
  readonly maxBytes: number;
}

/** Fetches a file once: throws BundleError if a retry is useless, any other error if it may help. */
export async function transfer(
  url: URL,
  limits: Limits,
  received: (bytes: number) => void,
  signal: AbortSignal,
  isRetry: boolean,
  network: Network,
): Promise<ArrayBuffer> {
  const timeout = new AbortController();
  const eitherSignal = AbortSignal.any([signal, timeout.signal]);
  let hasNewBytes = true;
  const watch = async (): Promise<void> => {
    while (hasNewBytes) {
      hasNewBytes = false;
      await network.wait(STALL_SECONDS, eitherSignal);
    }
    timeout.abort(new Error(`the server sends nothing for ${STALL_SECONDS} s`));
  };
  // Rejects when the transfer ends.
  watch().catch(() => undefined);
  let size = 0;
  try {
    const response = await network.fetch(url, eitherSignal, isRetry);
    checkStatus(limits.name, response);
    const parts: Uint8Array<ArrayBuffer>[] = [];
    for await (const chunk of chunksOf(response.body)) {
      hasNewBytes = true;
      parts.push(chunk);
      size += chunk.length;
      received(chunk.length);
      if (size > limits.maxBytes) throw tooLarge(limits);
    }
    // A broken transfer without a length looks complete.
    if (limits.bytes !== null && size < limits.bytes) throw new Error(`expected ${limits.bytes} bytes, got ${size}`);
    return await new Blob(parts).arrayBuffer();
  } catch (error) {
    received(-size);
    throw error;
  } finally {
    timeout.abort(new Error('over'));
  }
}

function checkStatus(name: string, { ok, status, statusText }: Response): void {
  if (ok) return;
  const answer = `the server answers ${status} ${statusText}`.trim();
  if (status >= 500 || RETRY_STATUSES.has(status)) throw new Error(answer);
  throw new BundleError(`${name}: ${answer}`, 'network');
}

function tooLarge({ name, bytes, maxBytes }: Limits): BundleError {
  const expected = bytes === null ? `at most ${maxBytes} bytes` : `${bytes} bytes, as the manifest lists it`;
  return new BundleError(`${name}: expected ${expected}, got more`);
}
