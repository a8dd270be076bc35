/** Files that one other page asks for: sent one after the other, no faster than they go. */
import type { Clock } from '../rooms/clock';
import { type Bucket, createBucket } from './bucket';
import { type Message, PART } from './messages';

/** Bytes that wait in the browser, from which on no more are sent, and of a file that are read at once. */
const [WAITING, READ] = [1 << 18, 4 * PART] as const;
/** Requests of one page at the same time. */
const MOST_OPEN = 64;
/** Requests a second that are answered with a file, and as many at once. */
const [RATE, BURST] = [100, 400] as const;
/** Times that one page gets a file: once, and again if it broke off. */
const MOST_TIMES = 2;
/** Bytes a second that all other pages get together, and at once: as much as a page keeps. */
const [BYTES_RATE, BYTES_BURST] = [4 * 2 ** 20, 64 * 2 ** 20] as const;

/** Where files are. */
export interface Shelf {
  find(key: string): Blob | null;
  /** See to it that a file comes; false if this page does not come by it. */
  obtain(key: string): boolean;
  /** Bytes of a file that are here, while it comes. */
  sizeOf(key: string): number;
}

export interface Uploads {
  /** A request has come; the answer is a sentence if it breaks the rules. */
  want(request: number, key: string): string | null;
  cancel(request: number): void;
  /** The other page waits for a file that is not here yet. */
  awaits(key: string): boolean;
  /** A file has come, or does not come. */
  settle(key: string): void;
  /** Tell of those that are waited for. */
  tick(): void;
  /** The browser can take more. */
  pump(): void;
  end(): void;
}

/** The part of the browser's channel to which uploads send. */
export interface Outlet {
  readonly bufferedAmount: number;
  send(message: Message): void;
  /** Bytes of files that were sent. */
  sent(bytes: number): void;
}

/** The bytes that a page gives to all others. */
export function createBudget(now: Clock['now']): Bucket {
  return createBucket(BYTES_RATE, BYTES_BURST, now);
}

export function createUploads(outlet: Outlet, shelf: Shelf, budget: Bucket, now: Clock['now']): Uploads {
  const rate = createBucket(RATE, BURST, now);
  /** How often the page got each file; keys are those of files that this page had. */
  const times = new Map<string, number>();
  /** Requests for files that are here, in their order, and for those that come, by key. */
  const ready = new Map<number, Blob>();
  const waiting = new Map<number, string>();
  let last = 0;
  let isSending = false;
  let resume = (): void => undefined;

  /** A file to send; null if the page gets it no more, or all pages have got too much. */
  function granted(key: string, found: Blob | null): Blob | null {
    const count = (times.get(key) ?? 0) + 1;
    if (!found || count > MOST_TIMES || !budget.take(found.size)) return null;
    times.set(key, count);
    return found;
  }

  /** Put a file in the queue, or answer that there is none. */
  function queue(request: number, file: Blob | null): void {
    if (file) ready.set(request, file);
    else outlet.send({ kind: 'none', request });
    void sendAll();
  }

  /** Send a file; stops where the request does. */
  async function sendParts(request: number, file: Blob): Promise<void> {
    for (let begin = 0; begin < file.size; begin += READ) {
      const data = new Uint8Array(await file.slice(begin, begin + READ).arrayBuffer());
      while (outlet.bufferedAmount > WAITING) await new Promise<void>((done) => (resume = done));
      for (let at = 0; at < data.length; at += PART) {
        if (!ready.has(request)) return;
        const part = data.subarray(at, at + PART);
        outlet.send({ kind: 'part', request, data: part });
        outlet.sent(part.length);
      }
    }
  }

  async function sendFile(request: number, file: Blob): Promise<void> {
    try {
      await sendParts(request, file);
    } catch {
      // The browser does not read it any more.
      if (ready.has(request)) outlet.send({ kind: 'none', request });
    }
    ready.delete(request);
  }

  async function sendAll(): Promise<void> {
    if (isSending) return;
    isSending = true;
    for (let next = first(ready); next; next = first(ready)) await sendFile(...next);
    isSending = false;
  }

  return {
    want(request, key) {
      if (request <= last) return 'a request has a number that was used';
      last = request;
      if (ready.size + waiting.size >= MOST_OPEN) return 'too much is asked for at once';
      const isFast = !rate.take(1);
      const found = isFast ? null : shelf.find(key);
      if (found) {
        queue(request, granted(key, found));
        return null;
      }
      // Before it is obtained: who waits for a file is not asked for it.
      waiting.set(request, key);
      if (!isFast && shelf.obtain(key)) {
        outlet.send({ kind: 'wait', request, bytes: shelf.sizeOf(key) });
      } else {
        waiting.delete(request);
        outlet.send({ kind: 'none', request });
      }
      return null;
    },
    cancel(request) {
      const isOpen = ready.delete(request) || waiting.delete(request);
      if (isOpen) outlet.send({ kind: 'none', request });
    },
    awaits: (key) => [...waiting.values()].includes(key),
    settle(key) {
      const found = shelf.find(key);
      for (const [request, wanted] of waiting) {
        if (wanted !== key) continue;
        waiting.delete(request);
        queue(request, granted(key, found));
      }
    },
    tick() {
      for (const [request, key] of waiting) outlet.send({ kind: 'wait', request, bytes: shelf.sizeOf(key) });
    },
    pump: () => resume(),
    end() {
      ready.clear();
      waiting.clear();
      resume();
    },
  };
}

function first<K, V>(entries: ReadonlyMap<K, V>): [K, V] | undefined {
  return entries.entries().next().value;
}
