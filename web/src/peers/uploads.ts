/** Files that another page requests: sent one after another, as fast as the channel's buffer allows. */
import { type Bucket, type Clock, createBucket } from '../rooms/clock';
import { type Message, PART } from './messages';

/** Greatest number of bytes in the browser's buffer; number of bytes of a file that are read at once. */
const [MAX_BUFFERED_BYTES, READ_BYTES] = [1 << 18, 4 * PART] as const;
/** Greatest number of concurrent requests of one page. */
const MAX_UPLOADS = 64;
/** Rate per second and burst of requests that are answered with a file. */
const [FILES_PER_SECOND, FILES_AT_ONCE] = [100, 400] as const;
/** Number of times that a page gets a file: once, and again after an interruption. */
const MAX_SENDS_PER_PAGE = 2;
/** Bytes per second and burst for all other pages together; the burst is the size of a page's store. */
const [BYTES_RATE, BYTES_BURST] = [4 * 2 ** 20, 64 * 2 ** 20] as const;

/** Source of files for uploads. */
export interface Shelf {
  find(key: string): Blob | null;
  /** Starts to fetch a file; returns false if this page cannot. */
  obtain(key: string): boolean;
  /** Number of bytes of a file in transfer that have arrived. */
  sizeOf(key: string): number;
}

/** Creates the budget of bytes that this page sends to all others. */
export function createBudget(now: Clock['now']): Bucket {
  return createBucket(BYTES_RATE, BYTES_BURST, now);
}

/** Creates the uploads to a page; `onSent` is called with the number of bytes of each part of a file that is sent. */
export function createUploads(
  channel: { readonly bufferedAmount: number },
  send: (message: Message) => void,
  onSent: (bytes: number) => void,
  shelf: Shelf,
  budget: Bucket,
  now: Clock['now'],
) {
  const fileRate = createBucket(FILES_PER_SECOND, FILES_AT_ONCE, now);
  /** Number of times that the page got each file. Only files of this page have entries, so it cannot be flooded. */
  const sendCounts = new Map<string, number>();
  /** Requests for files that this page has, in order; keys of requested files that are still arriving. */
  const ready = new Map<number, Blob>();
  const waiting = new Map<number, string>();
  let lastRequest = 0;
  let isSending = false;
  let resume = (): void => undefined;

  /** Queues a file; answers `none` if it is null, or if the limit of sends or the budget is exceeded. */
  function queue(request: number, key: string, file: Blob | null): void {
    const count = (sendCounts.get(key) ?? 0) + 1;
    if (file && count <= MAX_SENDS_PER_PAGE && budget.take(file.size)) {
      sendCounts.set(key, count);
      ready.set(request, file);
    } else send({ kind: 'none', request });
    void sendAll();
  }

  /** Sends a file in parts; stops if the request is cancelled. */
  async function sendParts(request: number, file: Blob): Promise<void> {
    for (let begin = 0; begin < file.size; begin += READ_BYTES) {
      const data = new Uint8Array(await file.slice(begin, begin + READ_BYTES).arrayBuffer());
      while (channel.bufferedAmount > MAX_BUFFERED_BYTES) await new Promise<void>((done) => (resume = done));
      for (let start = 0; start < data.length; start += PART) {
        if (!ready.has(request)) return;
        const part = data.subarray(start, start + PART);
        send({ kind: 'part', request, data: part });
        onSent(part.length);
      }
    }
  }

  async function sendFile(request: number, file: Blob): Promise<void> {
    try {
      await sendParts(request, file);
    } catch {
      // The browser cannot read the blob any more.
      if (ready.has(request)) send({ kind: 'none', request });
    }
    ready.delete(request);
  }

  async function sendAll(): Promise<void> {
    if (isSending) return;
    isSending = true;
    for (let [next] = ready; next; [next] = ready) await sendFile(...next);
    isSending = false;
  }

  return {
    /** Handles a request; returns a sentence if it violates the protocol. */
    handleRequest(request: number, key: string): string | null {
      if (request <= lastRequest) return 'a request reuses a number';
      lastRequest = request;
      if (ready.size + waiting.size >= MAX_UPLOADS) return 'too many requests are open';
      const isTooFast = !fileRate.take(1);
      const file = isTooFast ? null : shelf.find(key);
      if (file) {
        queue(request, key, file);
        return null;
      }
      // Recorded before `obtain`, so that this page does not request the file from the page that waits for it.
      waiting.set(request, key);
      if (!isTooFast && shelf.obtain(key)) send({ kind: 'wait', request, bytes: shelf.sizeOf(key) });
      else {
        waiting.delete(request);
        send({ kind: 'none', request });
      }
      return null;
    },
    cancel(request: number): void {
      const isOpen = ready.delete(request) || waiting.delete(request);
      if (isOpen) send({ kind: 'none', request });
    },
    /** Whether the other page waits for a file that is still arriving here. */
    awaits: (key: string): boolean => [...waiting.values()].includes(key),
    /** Answers requests for a file that has arrived, or will not arrive. */
    settle(key: string): void {
      const file = shelf.find(key);
      for (const [request, requestedKey] of waiting) {
        if (requestedKey !== key) continue;
        waiting.delete(request);
        queue(request, key, file);
      }
    },
    /** Reports the progress of files for which the other page waits. */
    tick(): void {
      for (const [request, key] of waiting) send({ kind: 'wait', request, bytes: shelf.sizeOf(key) });
    },
    /** Continues to send when the browser can buffer more bytes. */
    pump: (): void => resume(),
    end(): void {
      ready.clear();
      waiting.clear();
      resume();
    },
  };
}
