/** Server of a room: its description, sockets to it, and its reasons for ending connections. */
import { bytesOf } from '../base/bytes';

/** Hexadecimal digits of a SHA-256. */
const HASH = /^[0-9a-f]{64}$/;
/** Timeout of the description, milliseconds, after which the page joins the room without it. */
const ANSWER_TIMEOUT = 3000;

/** Description that the server gives of its rooms. */
export interface ServerDescription {
  /** Whether pages may exchange files. */
  readonly peers: boolean;
  /** Endpoint for datagrams; null for none. */
  readonly datagrams: Datagrams | null;
}

export interface Datagrams {
  readonly port: number;
  /** SHA-256 hashes of self-signed certificates. */
  readonly hashes: readonly Uint8Array<ArrayBuffer>[];
}

/** Requests the server's description; null if there is none. */
export type Ask = () => Promise<ServerDescription | null>;

/** Requests the description from the server of a page; null if there is none before `signal` aborts. */
export async function askDescription(page: string, signal = AbortSignal.timeout(ANSWER_TIMEOUT)) {
  try {
    const answer = await fetch(new URL('rooms', page), { cache: 'no-store', signal });
    return answer.ok ? readDescription(await answer.json()) : null;
  } catch {
    return null;
  }
}

/** Parses a description; null if it is malformed. */
export function readDescription(value: unknown): ServerDescription | null {
  if (!isRecord(value) || typeof value['peers'] !== 'boolean') return null;
  const { peers, datagrams } = value;
  return { peers, datagrams: isRecord(datagrams) ? readDatagrams(datagrams) : null };
}

function readDatagrams({ port, hashes }: Readonly<Record<string, unknown>>): Datagrams | null {
  const isPort = Number.isInteger(port) && Number(port) > 0 && Number(port) < 1 << 16;
  const areHashes = Array.isArray(hashes) && hashes.every((hash) => typeof hash === 'string' && HASH.test(hash));
  if (!isPort || !areHashes) return null;
  return { port: Number(port), hashes: hashes.map(bytesOf) };
}

function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null;
}

/** Seconds that a leaving user waits until the server closes the connection, which frees the place in the room. */
export const CLOSE_TIMEOUT = 5;

export interface Socket {
  readonly bufferedAmount: number;
  /** Sends a frame; `mayBeLost` if a later frame replaces it. */
  send(data: Uint8Array<ArrayBuffer>, mayBeLost: boolean): void;
  /** Closes after all frames are sent, or immediately. `onClose` is called when both sides have closed. */
  close(isImmediate: boolean): void;
}

/** Listener of a socket, which is not called before the socket is returned. */
export interface Listener {
  onOpen(): void;
  /** Called with whole frames as an ArrayBuffer, or with malformed data. */
  onData(data: unknown): void;
  /** Called with a WebSocket close code. */
  onClose(code: number): void;
}

export type Open = (url: string, listener: Listener) => Socket;

export function openSocket(url: string, listener: Listener): Socket {
  const socket = new WebSocket(url);
  socket.binaryType = 'arraybuffer';
  socket.onopen = () => listener.onOpen();
  socket.onmessage = ({ data }) => listener.onData(data);
  socket.onclose = ({ code }) => listener.onClose(code);
  return {
    get bufferedAmount() {
      return socket.bufferedAmount;
    },
    send: (data) => socket.send(data),
    close: () => socket.close(),
  };
}

/** WebSocket close code of a connection that ended without a reason. */
export const BROKEN_CODE = 1006;
/** Offset from a reason's code to its WebSocket close code. */
const REASON_OFFSET = 4000;

/** End of a connection. */
export interface End {
  readonly message: string;
  /** Whether a retry is useless. */
  readonly isFinal: boolean;
}

/** Ends of connections by the codes of reasons in docs/rooms.md. */
const ENDS: Readonly<Record<number, End>> = {
  2: { message: 'The server has another version of rooms than this page. Reload the page.', isFinal: true },
  3: { message: 'The server does not understand what this page sends.', isFinal: false },
  4: { message: 'This link does not let you into the room. Ask for another one.', isFinal: true },
  5: { message: 'The room is full.', isFinal: false },
  6: { message: 'This page has sent more than the server accepts.', isFinal: false },
  7: { message: 'The connection is too slow for this room.', isFinal: false },
  8: { message: 'The server has received nothing from this page.', isFinal: false },
  9: { message: 'You have entered the room elsewhere.', isFinal: true },
  10: { message: 'The server is shutting down.', isFinal: false },
};

/** Returns the end for a reason's code. */
export function endOf(reason: number): End {
  return ENDS[reason] ?? { message: 'The room has ended the connection.', isFinal: false };
}

/** Returns the end for a WebSocket close code; `wasInRoom` if the user was in the room. */
export function endOfCode(code: number, wasInRoom: boolean): End {
  if (code > REASON_OFFSET) return endOf(code - REASON_OFFSET);
  const message = wasInRoom ? 'The connection to the room was lost.' : 'The room cannot be reached.';
  return { message, isFinal: false };
}
