/** Payloads of `signal` frames, with which pages connect. docs/peers.md has a table of every field. */
import { FrameError, Reader, Writer } from '../rooms/bytes';

const VERSION = 1;
/** Greatest number of bytes of a description, and of its addresses that are used. */
const [MAX_BYTES, MAX_ADDRESSES] = [8192, 8] as const;
/** Lines with addresses; lines with a device's own UDP addresses: without a STUN server there are no others. */
const ADDRESS = /^\s*a=candidate:/i;
const OWN = /^a=candidate:\S+ \d+ udp \d+ \S+ \d+ typ host(?:\s|$)/i;
const KINDS = ['offer', 'answer', 'no'] as const;

/** Signal; `attempt` identifies an offer and its answer, `sdp` describes a connection and is empty for `no`. */
export interface Signal {
  readonly kind: (typeof KINDS)[number];
  readonly attempt: number;
  readonly sdp: string;
}

/** Parses a payload; throws `FrameError` if it is malformed or describes more than one data channel. */
export function readSignal(payload: Uint8Array): Signal {
  const reader = new Reader(payload);
  if (reader.u8() !== VERSION) throw new FrameError('a signal is of another version');
  const kind = KINDS[reader.u8()];
  if (!kind) throw new FrameError('a signal is of no kind that there is');
  const attempt = reader.u32();
  const sdp = textOf(reader.rest(MAX_BYTES));
  if (kind === 'no' ? sdp !== '' : !isDescription(sdp)) throw new FrameError('a signal describes no channel for data');
  return { kind, attempt, sdp: withFewAddresses(sdp) };
}

/** Writes a payload; throws `FrameError` for a description that others would reject. */
export function writeSignal({ kind, attempt, sdp }: Signal): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(sdp);
  if (text.length > MAX_BYTES) throw new FrameError('a description is too long');
  const out = new Writer();
  out.u8(VERSION);
  out.u8(KINDS.indexOf(kind));
  out.u32(attempt);
  out.put(text);
  return out.done();
}

function isDescription(sdp: string): boolean {
  const lines = sdp.split(/\r?\n/);
  const media = lines.filter((line) => line.startsWith('m='));
  return media.length === 1 && /^m=application /.test(media[0] ?? '');
}

/** Removes foreign and excess addresses: the browser sends packets to every address in a description. */
function withFewAddresses(sdp: string): string {
  let count = 0;
  const lines = sdp.split('\n').filter((line) => {
    if (!ADDRESS.test(line)) return true;
    return OWN.test(line) && ++count <= MAX_ADDRESSES;
  });
  return lines.join('\n');
}

function textOf(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new FrameError('a description is no text');
  }
}
