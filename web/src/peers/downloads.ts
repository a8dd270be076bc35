/** Files requested from another page. Time is counted in ticks, so that a suspended page sees no timeouts of others. */
import type { FileEntry } from '../bundle/manifest';
import type { Received } from '../bundle/source';
import { sha256 } from '../base/bytes';
import { abortable } from '../base/errors';
import { type Message, PART } from './messages';

/** Seconds per tick. */
export const TICK = 0.25;
/** Greatest number of concurrent requests to one page. */
const MAX_DOWNLOADS = 32;

/** Content of a file, or why it is missing: the page lacks it, has stopped sending, or has sent wrong data. */
export type Answer = ArrayBuffer | 'none' | 'silent' | 'wrong';

export interface RequestedFile extends FileEntry {
  /** Timeout in seconds without a received byte. */
  readonly quietTimeout: number;
  /** Timeout in seconds for the whole request, in addition to the time for its bytes. */
  readonly requestTimeout: number;
  /** Least transfer rate in bytes per second, which extends the timeout. */
  readonly minRate: number;
}

interface Download {
  readonly file: RequestedFile;
  readonly received: Received;
  readonly done: (answer: Answer) => void;
  data: Uint8Array<ArrayBuffer> | null;
  size: number;
  /** Number of bytes that the other page reports to have received itself, while the file is still arriving there. */
  reported: number;
  /** Ticks since the last byte; ticks since the request. */
  quietTicks: number;
  ageTicks: number;
  /** Whether the request has ended here; data that were sent before may still arrive. */
  hasEnded: boolean;
}

/** Creates the downloads from a page; `onViolation` is called with a sentence if a file has the wrong content. */
export function createDownloads(send: (message: Message) => void, onViolation: (sentence: string) => void) {
  const downloads = new Map<number, Download>();
  let lastRequest = 0;

  function finish(download: Download, answer: Answer): void {
    if (download.hasEnded) return;
    download.hasEnded = true;
    if (!(answer instanceof ArrayBuffer)) download.received(-download.size);
    download.data = null;
    download.done(answer);
  }

  function cancel(request: number, download: Download, answer: Answer): void {
    if (download.hasEnded) return;
    finish(download, answer);
    send({ kind: 'cancel', request });
  }

  function receivePart(request: number, download: Download, bytes: Uint8Array): string | null {
    const { file } = download;
    const expected = Math.min(PART, file.bytes - download.size);
    if (bytes.length === 0 || bytes.length !== expected) return 'a part has a wrong length';
    for (const each of downloads.values()) each.quietTicks = 0;
    if (!download.hasEnded) {
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
    const isCorrect = (await sha256(data)) === download.file.sha256;
    finish(download, isCorrect ? data : 'wrong');
    if (!isCorrect) onViolation('a file has the wrong content');
  }

  return {
    /** Number of open requests, including ended ones whose data may still arrive. */
    get openCount(): number {
      return downloads.size;
    },
    /** Whether the page can take another request: not too many are open, and none of them has ended here. */
    get isFree(): boolean {
      return downloads.size < MAX_DOWNLOADS && ![...downloads.values()].some(({ hasEnded }) => hasEnded);
    },
    /** Requests a file; `received` gets the number of its bytes, negative if received bytes are discarded. */
    request(file: RequestedFile, signal: AbortSignal, received: Received): Promise<Answer> {
      return abortable<Answer>(signal, (done) => {
        const request = ++lastRequest;
        const counts = { size: 0, reported: -1, quietTicks: 0, ageTicks: 0 };
        const download: Download = { file, received, done, data: null, hasEnded: false, ...counts };
        downloads.set(request, download);
        send({ kind: 'want', request, key: file.sha256 });
        return () => cancel(request, download, 'none');
      });
    },
    /** Handles a message; returns a sentence if the page violates the protocol. */
    hear(message: Extract<Message, { readonly request: number }>): string | null {
      const { request } = message;
      const download = downloads.get(request);
      if (!download) return 'a message answers no open request';
      if (message.kind === 'part') return receivePart(request, download, message.data);
      if (message.kind === 'wait') {
        if (message.bytes > download.file.bytes) return 'more bytes are reported than the file has';
        if (message.bytes > download.reported) download.quietTicks = 0;
        download.reported = Math.max(download.reported, message.bytes);
        return null;
      }
      downloads.delete(request);
      finish(download, 'none');
      return null;
    },
    tick(): void {
      for (const [request, download] of downloads) {
        if (download.hasEnded) continue;
        download.quietTicks += 1;
        download.ageTicks += 1;
        const { quietTimeout, requestTimeout, minRate, bytes } = download.file;
        const isLate = TICK * download.ageTicks > requestTimeout + bytes / minRate;
        if (isLate || TICK * download.quietTicks > quietTimeout) cancel(request, download, 'silent');
      }
    },
    /** Ends all requests, because the page has left. */
    end(): void {
      const all = [...downloads.values()];
      downloads.clear();
      for (const download of all) finish(download, 'silent');
    },
  };
}
