/** Files that one other page asks for: sent one after the other, no faster than they go. */
import type { Clock } from '../rooms/clock';
import { createBucket } from './bucket';
import { type Message, PART } from './messages';

/** Bytes that wait in the browser, from which on no more are sent, and of a file that are read at once. */
const [WAITING, READ] = [1 << 18, 4 * PART] as const;
/** Requests of one page at the same time. */
const MOST_OPEN = 64;
/** Requests a second that are answered with a file, and as many at once. */
const [RATE, BURST] = [100, 400] as const;

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

export function createUploads(outlet: Outlet, shelf: Shelf, now: Clock['now']): Uploads {
  const rate = createBucket(RATE, BURST, now);
  /** Requests for files that are here, in their order, and for those that come, by key. */
  const ready = new Map<number, Blob>();
  const waiting = new Map<number, string>();
  let last = 0;
  let isSending = false;
  let resume = (): void => undefined;

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
        ready.set(request, found);
        void sendAll();
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
        if (found) ready.set(request, found);
        else outlet.send({ kind: 'none', request });
      }
      void sendAll();
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
