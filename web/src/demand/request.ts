/** Requests what a server makes on demand, and reads JSON lines of its answer. */
import { chunksOf } from '../base/bytes';
import { BundleError, type Kind } from '../bundle/error';
import { parseJson } from '../bundle/parse';
import { withRetries } from '../bundle/source';
import type { Network } from '../bundle/transfer';

/** Default and greatest pause before a request to a busy server is repeated, seconds. */
const [DEFAULT_PAUSE, MAX_PAUSE] = [2, 60] as const;
/** Status codes of a busy server: too many requests of this client, or of all clients. */
const BUSY = [429, 503];
/** Greatest length of a displayed reason. */
const MAX_REASON_LENGTH = 300;

/**
 * Requests a URL until the server is not busy; throws a BundleError of `kind` if the server refuses. `onBusy` is called
 * with the seconds of each pause.
 */
export async function request(
  url: URL,
  kind: Kind,
  onBusy: (seconds: number) => void,
  signal: AbortSignal,
  network: Network,
): Promise<Response> {
  return withRetries('the server cannot be reached', signal, network, async () => {
    for (;;) {
      const response = await network.fetch(url, signal, false);
      if (response.ok) return response;
      if (!BUSY.includes(response.status)) throw new BundleError(await reasonOf(response), kind);
      const pause = pauseOf(response);
      onBusy(pause);
      await network.wait(pause, signal);
    }
  });
}

function pauseOf({ headers }: Response): number {
  const seconds = Number(headers.get('retry-after') ?? DEFAULT_PAUSE);
  return Number.isFinite(seconds) ? Math.min(Math.max(seconds, 1), MAX_PAUSE) : DEFAULT_PAUSE;
}

/** Reason in an error response, without the leading status. */
async function reasonOf(response: Response): Promise<string> {
  const text = (await response.text()).trim().slice(0, MAX_REASON_LENGTH);
  return text.replace(/^\d{3} [^:]*: /, '') || `the server answers ${response.status} ${response.statusText}`.trim();
}

/** Yields each line's document as soon as it is complete; rejects lines longer than `maxLength` characters. */
export async function* linesOf(name: string, response: Response, maxLength: number): AsyncGenerator<unknown> {
  const decoder = new TextDecoder();
  let partialLine = '';
  for await (const chunk of chunksOf(response.body)) {
    const lines = (partialLine + decoder.decode(chunk, { stream: true })).split('\n');
    partialLine = lines.pop() ?? '';
    for (const line of lines) yield parseJson(name, line);
    if (partialLine.length > maxLength) throw new BundleError(`${name}: expected lines of at most ${maxLength} characters`);
  }
  partialLine += decoder.decode();
  if (partialLine !== '') yield parseJson(name, partialLine);
}
