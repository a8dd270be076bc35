/** Another page with an open channel: its files, and the requests to it and from it. */
import type { Received } from '../bundle/source';
import { FrameError } from '../rooms/bytes';
import { type Bucket, type Clock, createBucket } from '../rooms/clock';
import { type Answer, createDownloads, type RequestedFile } from './downloads';
import { type Holding, MAX_FILES_PER_MESSAGE, type Message, readMessage, writeMessage } from './messages';
import { createUploads, type Shelf } from './uploads';

/** Rate per second and burst of received messages except parts; number of listed files that count as a message. */
const [RATE, BURST, KEYS_PER_MESSAGE] = [512, 2048, 50] as const;
/** Number of timeouts after which a page gets no more requests; simultaneous timeouts count once. */
const MAX_TIMEOUTS = 3;
/** Rate per second and burst of this page's requests, below the limit of the pages that answer. */
const [REQUEST_RATE, REQUEST_BURST] = [80, 300] as const;
/** Greatest number of files remembered per page; more are ignored. */
const MAX_KNOWN_FILES = 8192;
/** Number of buffered bytes below which the browser calls `onbufferedamountlow`. */
const MIN_BUFFERED_BYTES = 1 << 17;

/** Subset of the interface of data channels that is used. */
export type Channel = Pick<
  RTCDataChannel,
  'binaryType' | 'bufferedAmount' | 'bufferedAmountLowThreshold' | 'onbufferedamountlow' | 'onmessage' | 'send'
>;

export interface PeerSettings {
  readonly number: number;
  readonly channel: Channel;
  readonly shelf: Shelf;
  /** Budget of bytes that this page sends to all others. */
  readonly budget: Bucket;
  readonly now: Clock['now'];
  /** Called with the number of sent bytes of files. */
  readonly onSent: (bytes: number) => void;
  /** Called when the other page has sent its first list of files, which may be empty. */
  readonly onFiles: () => void;
  /** Called when the other page violates the protocol. */
  readonly onViolation: (sentence: string) => void;
}

export type Peer = ReturnType<typeof createPeer>;

export function createPeer({ number, channel, shelf, budget, now, onSent, onFiles, onViolation }: PeerSettings) {
  const holdings = new Map<string, Holding>();
  const messageRate = createBucket(RATE, BURST, now);
  const requestRate = createBucket(REQUEST_RATE, REQUEST_BURST, now);
  let [hasEnded, hasSentFiles, ticks] = [false, false, 0];
  /** Ticks in which requests remained unanswered. */
  const timeouts = new Set<number>();

  function send(message: Message): void {
    if (hasEnded) return;
    try {
      channel.send(writeMessage(message));
    } catch {
      // The browser has closed the channel; an event follows.
    }
  }

  const downloads = createDownloads(send, onViolation);
  const uploads = createUploads(channel, send, onSent, shelf, budget, now);

  function handle(message: Message): string | null {
    const cost = message.kind === 'part' ? 0 : message.kind === 'tell' ? 1 + message.keys.length / KEYS_PER_MESSAGE : 1;
    if (!messageRate.take(cost)) return 'it sends too many messages';
    switch (message.kind) {
      case 'tell':
        for (const key of message.keys) {
          if (message.holding === 'gone') holdings.delete(key);
          else if (holdings.has(key) || holdings.size < MAX_KNOWN_FILES) holdings.set(key, message.holding);
        }
        if (!hasSentFiles && message.holding === 'here') {
          hasSentFiles = true;
          onFiles();
        }
        return null;
      case 'want':
        return uploads.handleRequest(message.request, message.key);
      case 'cancel':
        uploads.cancel(message.request);
        return null;
      default:
        return downloads.hear(message);
    }
  }

  channel.binaryType = 'arraybuffer';
  channel.bufferedAmountLowThreshold = MIN_BUFFERED_BYTES;
  channel.onbufferedamountlow = uploads.pump;
  channel.onmessage = ({ data }: MessageEvent<unknown>) => {
    if (hasEnded) return;
    try {
      if (!(data instanceof ArrayBuffer)) throw new FrameError('a message is text instead of bytes');
      const sentence = handle(readMessage(new Uint8Array(data)));
      if (sentence !== null) onViolation(sentence);
    } catch (error) {
      if (!(error instanceof FrameError)) throw error;
      onViolation(error.message);
    }
  };

  return {
    number,
    get openCount(): number {
      return downloads.openCount;
    },
    get isFree(): boolean {
      return !hasEnded && timeouts.size < MAX_TIMEOUTS && downloads.isFree && requestRate.secondsTo(1) === 0;
    },
    /** State of a file on the other page, as far as known. */
    holdingOf: (key: string): Holding => holdings.get(key) ?? 'gone',
    /** Sends the state of files on this page; the list may be empty. */
    tell(holding: Holding, keys: readonly string[]): void {
      let start = 0;
      do {
        send({ kind: 'tell', holding, keys: keys.slice(start, start + MAX_FILES_PER_MESSAGE) });
        start += MAX_FILES_PER_MESSAGE;
      } while (start < keys.length);
    },
    async request(file: RequestedFile, signal: AbortSignal, received: Received): Promise<Answer> {
      requestRate.take(1);
      const answer = await downloads.request(file, signal, received);
      if (answer === 'silent') timeouts.add(ticks);
      if (answer === 'none') holdings.delete(file.sha256);
      return answer;
    },
    /** Whether the other page waits for a file from this one. */
    awaits: uploads.awaits,
    /** Answers requests for a file that has arrived at this page, or will not arrive. */
    settle: uploads.settle,
    /** Advances time by a tick; `isSecond` is true once per second. */
    tick(isSecond: boolean): void {
      ticks += 1;
      downloads.tick();
      if (isSecond) uploads.tick();
    },
    end(): void {
      hasEnded = true;
      downloads.end();
      uploads.end();
    },
  };
}
