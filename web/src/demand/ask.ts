/** Asks a server for something that it makes on demand: again when it is busy, or when it cannot be reached. */
import { BundleError, type Kind } from '../bundle/error';
import type { Network } from '../bundle/transfer';

/** Seconds before each new trial when the server cannot be reached. */
const PAUSES = [0.5, 1, 2, 4] as const;
/** Seconds after which a busy server is asked again, if it says nothing, and at most. */
const [LATER, LATEST] = [2, 60] as const;
/** Answers of a server that is busy: this client waits for too much, or all clients do. */
const BUSY = [429, 503];
/** Greatest length of a reason that is shown. */
const MOST_REASON = 300;

/** The answer of a server; BundleError of a kind if it refuses. `busy` is told of the seconds of each pause. */
export async function ask(
  url: URL,
  kind: Kind,
  busy: (seconds: number) => void,
  signal: AbortSignal,
  network: Network,
): Promise<Response> {
  for (let trial = 0; ; ) {
    signal.throwIfAborted();
    const response = await network.fetch(url, signal, false).catch((error: unknown) => error);
    if (response instanceof Response && response.ok) return response;
    let pause: number | undefined;
    if (!(response instanceof Response)) {
      pause = PAUSES[trial++];
      const reason = response instanceof Error ? response.message : String(response);
      if (pause === undefined) throw new BundleError(`the server cannot be reached: ${reason}`, 'network');
    } else if (BUSY.includes(response.status)) {
      pause = pauseOf(response);
      busy(pause);
    } else {
      throw new BundleError(await reasonOf(response), kind);
    }
    await network.wait(pause, signal);
  }
}

function pauseOf({ headers }: Response): number {
  const told = Number(headers.get('retry-after') ?? LATER);
  return Number.isFinite(told) ? Math.min(Math.max(told, 1), LATEST) : LATER;
}

/** The server's sentence, without the status before it. */
async function reasonOf(response: Response): Promise<string> {
  const text = (await response.text()).trim().slice(0, MOST_REASON);
  return text.replace(/^\d{3} [^:]*: /, '') || `the server answers ${response.status} ${response.statusText}`.trim();
}
