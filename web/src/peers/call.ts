/** WebRTC connection to one other page with one data channel, and the signals that set it up. */
import { choiceOf, decode, encode, FrameError, payload, record, U32, utf8, type ValueOf } from '../rooms/bytes';
import { withPrefix } from '../rooms/bytes';
import { type Clock, createBucket } from '../rooms/clock';
import type { Channel } from './peer';

/** Timeout in seconds for gathering the browser's own addresses. */
const GATHER_TIMEOUT = 1;
/** Settings of the data channel that both pages share. It is reliable and ordered. */
const CHANNEL_SETTINGS = { negotiated: true, id: 0, ordered: true } as const;

export interface CallEvents {
  /** Called when the channel can be used. */
  readonly onOpen: (channel: Channel) => void;
  /** Called when the connection has ended or could not be established. */
  readonly onEnd: () => void;
  /** Called when the other page violates the protocol. */
  readonly onViolation: (sentence: string) => void;
}

export type Call = ReturnType<typeof createCall>;

export function createCall({ onOpen, onEnd, onViolation }: CallEvents, later: Clock['later']) {
  // There is no STUN server: pages connect in a local network, or if they have public addresses.
  const connection = new RTCPeerConnection({ iceServers: [] });
  const channel = connection.createDataChannel('files', CHANNEL_SETTINGS);
  channel.onopen = () => onOpen(channel);
  channel.onclose = onEnd;
  connection.ondatachannel = () => onViolation('it opens another channel');
  connection.onconnectionstatechange = () => {
    if (['failed', 'closed'].includes(connection.connectionState)) onEnd();
  };

  /** Returns the description with all addresses, so that one signal suffices. */
  async function localDescription(): Promise<string> {
    await connection.setLocalDescription();
    if (connection.iceGatheringState !== 'complete') {
      await new Promise<void>((done) => {
        const stop = later(GATHER_TIMEOUT, done);
        connection.onicegatheringstatechange = () => {
          if (connection.iceGatheringState !== 'complete') return;
          stop();
          done();
        };
      });
    }
    return connection.localDescription?.sdp ?? '';
  }

  return {
    offer: localDescription,
    async answer(offer: string): Promise<string> {
      await connection.setRemoteDescription({ type: 'offer', sdp: offer });
      return localDescription();
    },
    /** Applies the other page's answer. */
    accept: (answer: string): Promise<void> => connection.setRemoteDescription({ type: 'answer', sdp: answer }),
    close(): void {
      channel.onclose = connection.onconnectionstatechange = null;
      connection.close();
    },
  };
}

/** Version of signals, the payloads of `signal` frames: docs/peers.md has a table of every field. */
const VERSION = 1;
/** Greatest number of bytes of a description, and of its addresses that are used. */
const [MAX_BYTES, MAX_ADDRESSES] = [8192, 8] as const;
/** Lines with addresses; lines with UDP addresses of the device itself. Without a STUN server there are no others. */
const ADDRESS_LINE = /^\s*a=candidate:/i;
const OWN_ADDRESS_LINE = /^a=candidate:\S+ \d+ udp \d+ \S+ \d+ typ host(?:\s|$)/i;
const SIGNAL = record({
  kind: choiceOf(['offer', 'answer', 'no'], 'a signal has an unknown kind'),
  /** Identifies an offer and its answer. */
  attempt: U32,
  /** Description of a connection; empty for `no`. */
  sdp: utf8(payload(MAX_BYTES, 'a description is too long'), 'a description is not UTF-8'),
});
const PAYLOAD = withPrefix(VERSION, 'a signal has another version', SIGNAL);
export type Signal = ValueOf<typeof SIGNAL>;

/** Parses a payload; throws `FrameError` if it is malformed or describes more than one data channel. */
export function readSignal(payload: Uint8Array): Signal {
  const { kind, attempt, sdp } = decode(PAYLOAD, payload);
  if (kind === 'no' ? sdp !== '' : !isDescription(sdp)) throw new FrameError('a signal describes no channel for data');
  return { kind, attempt, sdp: withFewAddresses(sdp) };
}

/** Writes a payload; throws `FrameError` for a description that others would reject. */
export function writeSignal(signal: Signal): Uint8Array<ArrayBuffer> {
  return encode(PAYLOAD, signal);
}

function isDescription(sdp: string): boolean {
  const lines = sdp.split(/\r?\n/);
  const media = lines.filter((line) => line.startsWith('m='));
  return media.length === 1 && /^m=application /.test(media[0] ?? '');
}

/** Removes foreign and excess addresses, because browsers send packets to each address in a description. */
function withFewAddresses(sdp: string): string {
  let count = 0;
  const lines = sdp.split('\n').filter((line) => {
    if (!ADDRESS_LINE.test(line)) return true;
    return OWN_ADDRESS_LINE.test(line) && ++count <= MAX_ADDRESSES;
  });
  return lines.join('\n');
}

/** Bytes per second and burst, below the limits of docs/rooms.md; least number of bytes that a signal counts as. */
const [BYTES_PER_SECOND, BURST_BYTES, MIN_SIGNAL_BYTES] = [24_576, 12_288, 64] as const;
const MAX_QUEUED_SIGNALS = 64;

/** Creates a queue that sends signals no faster than the room accepts them. */
export function createOutbox(send: (user: number, payload: Uint8Array) => void, clock: Clock) {
  const bucket = createBucket(BYTES_PER_SECOND, BURST_BYTES, clock.now);
  let queue: (readonly [user: number, payload: Uint8Array])[] = [];
  let isScheduled = false;

  function flush(): void {
    for (let [next] = queue; next; [next] = queue) {
      const [user, payload] = next;
      const size = Math.min(Math.max(payload.length, MIN_SIGNAL_BYTES), BURST_BYTES);
      if (!bucket.take(size)) {
        isScheduled = true;
        clock.later(bucket.secondsTo(size) + 0.01, () => {
          isScheduled = false;
          flush();
        });
        return;
      }
      queue = queue.slice(1);
      send(user, payload);
    }
  }

  return {
    send(user: number, payload: Uint8Array): void {
      if (queue.length >= MAX_QUEUED_SIGNALS) return;
      queue.push([user, payload]);
      if (!isScheduled) flush();
    },
    /** Discards queued signals. */
    clear(): void {
      queue = [];
    },
  };
}
