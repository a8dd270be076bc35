/** Another page to which a channel is open: what it has, what it is asked for, and what it asks for. */
import type { Received } from '../bundle/source';
import { FrameError } from '../rooms/bytes';
import type { Clock } from '../rooms/clock';
import { type Bucket, createBucket } from './bucket';
import { type Answer, createDownloads, type Wanted } from './downloads';
import { type Holding, type Message, MOST_TOLD, readMessage, writeMessage } from './messages';
import { createUploads, type Shelf } from './uploads';

/** Messages a second besides parts, and as many at once; so many files that a message tells of count as one. */
const [RATE, BURST, TOLD] = [512, 2048, 50] as const;
/** Times that a page may leave requests without an answer before it is asked no more; those at once are one. */
const MOST_SILENT = 3;
/** Requests a second that a page makes, and at once: fewer than others answer. */
const [ASKED_RATE, ASKED_BURST] = [80, 300] as const;
/** Files of which a page may tell; of more it tells in vain. */
const MOST_KNOWN = 8192;
/** Bytes that wait in the browser, at which it asks for more. */
const LOW = 1 << 17;

/** The part of the browser's channel for data that is used. */
export type Line = Pick<
  RTCDataChannel,
  'binaryType' | 'bufferedAmount' | 'bufferedAmountLowThreshold' | 'onbufferedamountlow' | 'onmessage' | 'send'
>;

export interface PeerSettings {
  readonly number: number;
  readonly line: Line;
  readonly shelf: Shelf;
  /** Bytes that this page gives to all others. */
  readonly budget: Bucket;
  readonly now: Clock['now'];
  /** Bytes of files that were sent. */
  readonly sent: (bytes: number) => void;
  /** The page has told for the first time of files that it has, or that it has none. */
  readonly greeted: () => void;
  /** The page has broken the rules. */
  readonly refuse: (sentence: string) => void;
}

export interface Peer {
  /** The user's number. */
  readonly number: number;
  readonly open: number;
  readonly isFree: boolean;
  /** How it comes by a file, as far as it has told. */
  holds(key: string): Holding;
  /** It waits for a file from this page. */
  awaits(key: string): boolean;
  /** Tell it of files; of none, too. */
  tell(holding: Holding, keys: readonly string[]): void;
  ask(file: Wanted, signal: AbortSignal, received: Received): Promise<Answer>;
  /** A file has come to this page, or does not come. */
  settle(key: string): void;
  /** So much time has passed; `isSecond` from time to time, when a second has. */
  tick(isSecond: boolean): void;
  end(): void;
}

export function createPeer({ number, line, shelf, budget, now, sent, greeted, refuse }: PeerSettings): Peer {
  const known = new Map<string, Holding>();
  const messages = createBucket(RATE, BURST, now);
  const asked = createBucket(ASKED_RATE, ASKED_BURST, now);
  let [isOver, hasGreeted, ticks] = [false, false, 0];
  /** Ticks at which it had left requests without an answer. */
  const silences = new Set<number>();

  function send(message: Message): void {
    if (isOver) return;
    try {
      line.send(writeMessage(message));
    } catch {
      // The browser has closed the channel, and tells so by an event.
    }
  }

  const outlet = {
    get bufferedAmount() {
      return line.bufferedAmount;
    },
    send,
    sent,
  };
  const downloads = createDownloads(send, refuse);
  const uploads = createUploads(outlet, shelf, budget, now);

  function learn(holding: Holding, keys: readonly string[]): void {
    for (const key of keys) {
      if (holding === 'gone') known.delete(key);
      else if (known.has(key) || known.size < MOST_KNOWN) known.set(key, holding);
    }
  }

  function follow(message: Message): string | null {
    const cost = message.kind === 'part' ? 0 : message.kind === 'tell' ? 1 + message.keys.length / TOLD : 1;
    if (!messages.take(cost)) return 'it sends more than it may';
    switch (message.kind) {
      case 'tell':
        learn(message.holding, message.keys);
        if (!hasGreeted && message.holding === 'here') {
          hasGreeted = true;
          greeted();
        }
        return null;
      case 'want':
        return uploads.want(message.request, message.key);
      case 'cancel':
        uploads.cancel(message.request);
        return null;
      default:
        return downloads.hear(message);
    }
  }

  line.binaryType = 'arraybuffer';
  line.bufferedAmountLowThreshold = LOW;
  line.onbufferedamountlow = uploads.pump;
  line.onmessage = ({ data }: MessageEvent<unknown>) => {
    if (isOver) return;
    try {
      if (!(data instanceof ArrayBuffer)) throw new FrameError('a message is a text');
      const sentence = follow(readMessage(new Uint8Array(data)));
      if (sentence !== null) refuse(sentence);
    } catch (error) {
      if (!(error instanceof FrameError)) throw error;
      refuse(error.message);
    }
  };

  return {
    number,
    get open() {
      return downloads.open;
    },
    get isFree() {
      return !isOver && silences.size < MOST_SILENT && downloads.isFree && asked.secondsTo(1) === 0;
    },
    holds: (key) => known.get(key) ?? 'gone',
    tell(holding, keys) {
      let at = 0;
      do {
        send({ kind: 'tell', holding, keys: keys.slice(at, at + MOST_TOLD) });
        at += MOST_TOLD;
      } while (at < keys.length);
    },
    async ask(file, signal, received) {
      asked.take(1);
      const answer = await downloads.ask(file, signal, received);
      if (answer === 'silent') silences.add(ticks);
      if (answer === 'none') known.delete(file.sha256);
      return answer;
    },
    awaits: uploads.awaits,
    settle: uploads.settle,
    tick(isSecond) {
      ticks += 1;
      downloads.tick();
      if (isSecond) uploads.tick();
    },
    end() {
      isOver = true;
      downloads.end();
      uploads.end();
    },
  };
}
