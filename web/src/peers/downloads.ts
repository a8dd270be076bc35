/** Files that a page asks another one for. Time is counted in ticks: a page that stood still blames nobody for it. */
import type { Described } from '../bundle/manifest';
import type { Received } from '../bundle/source';
import { sha256 } from '../hex';
import { type Message, PART } from './messages';

/** Seconds of a tick. */
export const TICK = 0.25;
/** Requests to one page at the same time. */
const MOST_OPEN = 32;

/** The content of a file, or why there is none: the page has it not, sends nothing more, or has sent another one. */
export type Answer = ArrayBuffer | 'none' | 'silent' | 'wrong';

export interface Wanted extends Described {
  /** Seconds without a byte after which the request is given up. */
  readonly patience: number;
  /** Seconds that it may take, beside those for its bytes. */
  readonly longest: number;
  /** Bytes a second that come at least, after these seconds. */
  readonly slowest: number;
}

export interface Downloads {
  /** Requests that are open, those that were given up and still end among them. */
  readonly open: number;
  /** The page may be asked: it has room, and has not left a request without an end. */
  readonly isFree: boolean;
  /** Ask for a file; `received` is told of its bytes, and of how many count no longer (below 0). */
  ask(file: Wanted, signal: AbortSignal, received: Received): Promise<Answer>;
  /** A message has come; the answer is a sentence if the page breaks the rules. */
  hear(message: Extract<Message, { readonly request: number }>): string | null;
  tick(): void;
  /** The page is gone: nothing more comes. */
  end(): void;
}

interface Download {
  readonly file: Wanted;
  readonly received: Received;
  readonly done: (answer: Answer) => void;
  data: Uint8Array<ArrayBuffer> | null;
  size: number;
  /** Bytes that the other page has told to have, while it waits for the file itself. */
  told: number;
  /** Ticks without a byte, and all of them. */
  quiet: number;
  age: number;
  /** Nobody waits for it any more; what is on its way still comes. */
  isOver: boolean;
}

/** `refuse` is told a sentence when a file is another one than was asked for. */
export function createDownloads(send: (message: Message) => void, refuse: (sentence: string) => void): Downloads {
  const downloads = new Map<number, Download>();
  let last = 0;

  function give(download: Download, answer: Answer): void {
    if (download.isOver) return;
    download.isOver = true;
    if (!(answer instanceof ArrayBuffer)) download.received(-download.size);
    download.data = null;
    download.done(answer);
  }

  function giveUp(request: number, download: Download, answer: Answer): void {
    if (download.isOver) return;
    give(download, answer);
    send({ kind: 'cancel', request });
  }

  function part(request: number, download: Download, bytes: Uint8Array): string | null {
    const { file } = download;
    const expected = Math.min(PART, file.bytes - download.size);
    if (bytes.length === 0 || bytes.length !== expected) return 'a part has a wrong length';
    for (const each of downloads.values()) each.quiet = 0;
    if (!download.isOver) {
      download.data ??= new Uint8Array(file.bytes);
      download.data.set(bytes, download.size);
      download.received(bytes.length);
    }
    download.size += bytes.length;
    if (download.size < file.bytes) return null;
    downloads.delete(request);
    if (download.data) void check(download, download.data.buffer);
    return null;
  }

  async function check(download: Download, data: ArrayBuffer): Promise<void> {
    const isRight = (await sha256(data)) === download.file.sha256;
    give(download, isRight ? data : 'wrong');
    if (!isRight) refuse('a file is another one than was asked for');
  }

  return {
    get open() {
      return downloads.size;
    },
    get isFree() {
      return downloads.size < MOST_OPEN && ![...downloads.values()].some(({ isOver }) => isOver);
    },
    ask(file, signal, received) {
      signal.throwIfAborted();
      const request = ++last;
      return new Promise((done, failed) => {
        const stopped = (): void => {
          failed(signal.reason as Error);
          giveUp(request, download, 'none');
        };
        const ended = (answer: Answer): void => {
          signal.removeEventListener('abort', stopped);
          done(answer);
        };
        const counts = { size: 0, told: -1, quiet: 0, age: 0 };
        const download: Download = { file, received, done: ended, data: null, isOver: false, ...counts };
        downloads.set(request, download);
        signal.addEventListener('abort', stopped, { once: true });
        send({ kind: 'want', request, key: file.sha256 });
      });
    },
    hear(message) {
      const { request } = message;
      const download = downloads.get(request);
      if (!download) return 'a message answers nothing that was asked for';
      if (message.kind === 'part') return part(request, download, message.data);
      if (message.kind === 'wait') {
        if (message.bytes > download.file.bytes) return 'more of a file is there than it has';
        if (message.bytes > download.told) download.quiet = 0;
        download.told = Math.max(download.told, message.bytes);
        return null;
      }
      downloads.delete(request);
      give(download, 'none');
      return null;
    },
    tick() {
      for (const [request, download] of downloads) {
        if (download.isOver) continue;
        download.quiet += 1;
        download.age += 1;
        const { patience, longest, slowest, bytes } = download.file;
        const isLate = TICK * download.age > longest + bytes / slowest;
        if (isLate || TICK * download.quiet > patience) giveUp(request, download, 'silent');
      }
    },
    end() {
      const all = [...downloads.values()];
      downloads.clear();
      for (const download of all) give(download, 'silent');
    },
  };
}
