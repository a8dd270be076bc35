/** Transports to rooms: WebTransport with a stream and datagrams if both sides support it, else a WebSocket. */
import { concatBytes } from '../base/bytes';
import { abortable } from '../base/errors';
import { CLOCK, type Clock } from './clock';
import type { Ask, Datagrams, Listener, Open, Socket } from './server';
import { BROKEN_CODE, CLOSE_TIMEOUT, openSocket } from './server';

/** Seconds after a failure before an endpoint for datagrams is tried again. */
const RETRY_SECONDS = 60;

export interface Transports {
  /** Returns the server's endpoint for datagrams; null for none. */
  readonly datagrams: () => Promise<Datagrams | null>;
  readonly openDatagrams: (relay: string, to: Datagrams, listener: Listener) => Promise<Socket>;
  readonly openSocket: Open;
}

/** Opens sockets by the best transport that the server supports; only WebSockets if `isWebSocketOnly`. */
export function createOpen(
  ask: Ask,
  isWebSocketOnly: boolean,
  transports: Transports = browserTransports(ask),
  clock: Clock = CLOCK,
): Open {
  let failedEndpoint = '';
  let failedAt = -Infinity;

  async function open(url: string, listener: Listener): Promise<readonly [socket: Socket, isOpen: boolean]> {
    // The description is requested each time, because the server may have a new certificate.
    const endpoint = isWebSocketOnly ? null : await transports.datagrams();
    if (endpoint && (nameOf(endpoint) !== failedEndpoint || clock.now() - failedAt >= RETRY_SECONDS)) {
      try {
        return [await transports.openDatagrams(url, endpoint, listener), true];
      } catch {
        [failedEndpoint, failedAt] = [nameOf(endpoint), clock.now()];
      }
    }
    return [transports.openSocket(url, listener), false];
  }

  return (url, listener) => createDeferredSocket(open(url, listener), listener);
}

function nameOf({ port, hashes }: Datagrams): string {
  return `${port} ${hashes.join(' ')}`;
}

function browserTransports(ask: Ask): Transports {
  return {
    async datagrams() {
      if (typeof WebTransport === 'undefined') return null;
      return (await ask())?.datagrams ?? null;
    },
    openDatagrams,
    openSocket,
  };
}

/** Creates a socket before its connection is open; what is sent before that is discarded. */
function createDeferredSocket(
  opening: Promise<readonly [socket: Socket, isOpen: boolean]>,
  listener: Listener,
): Socket {
  let socket: Socket | null = null;
  let isClosed = false;
  opening.then(([openedSocket, isOpen]) => {
    socket = openedSocket;
    if (isClosed) socket.close(true);
    else if (isOpen) listener.onOpen();
  }, () => listener.onClose(BROKEN_CODE));
  return {
    get bufferedAmount() {
      return socket?.bufferedAmount ?? 0;
    },
    send(data, mayBeLost) {
      socket?.send(data, mayBeLost);
    },
    close(isImmediate) {
      isClosed = true;
      socket?.close(isImmediate);
    },
  };
}

/** Timeout for a connection by WebTransport, seconds: networks that drop UDP do not report it. */
const CONNECT_TIMEOUT = 3;
/** Greatest number of queued datagrams; others are dropped. */
const MAX_QUEUED = 4;
/** Greatest age of a queued datagram, milliseconds; older ones are dropped. */
const MAX_AGE = 50;
/** Bytes of a frame's header; the last two are the length of the body. */
const HEADER_BYTES = 3;

/**
 * Connects to the server's port for datagrams by WebTransport. Reliable frames use a stream; frames that later ones
 * replace use datagrams. Rejects on failure; the listener is not called before the promise resolves.
 */
export async function openDatagrams(relay: string, to: Datagrams, listener: Listener): Promise<Socket> {
  const transport = new WebTransport(addressOf(relay, to), {
    congestionControl: 'low-latency',
    serverCertificateHashes: to.hashes.map((value) => ({ algorithm: 'sha-256', value })),
  });
  const closed = transport.closed.then(({ closeCode }) => closeCode || BROKEN_CODE, () => BROKEN_CODE);
  try {
    const opening = transport.ready.then(() => transport.createBidirectionalStream());
    const stream = await withTimeout(CONNECT_TIMEOUT, opening);
    // Sessions may fail above, as in browsers with another version of WebTransport; then the listener is not called.
    const socket = createSocket(transport, stream.writable, closed);
    void closed.then((code) => listener.onClose(code));
    void readAll(stream.readable, createSplitter((frames) => listener.onData(frames)));
    void readAll(transport.datagrams.readable, (datagram) => listener.onData(datagram.slice().buffer));
    return socket;
  } catch (error) {
    transport.close();
    throw error;
  }
}

/** Address of a room's relay at the port for datagrams. */
export function addressOf(relay: string, { port }: Datagrams): string {
  const address = new URL(relay);
  address.protocol = 'https:';
  address.port = String(port);
  return address.href;
}

function createSocket(transport: WebTransport, writable: WritableStream, closed: Promise<unknown>): Socket {
  const { datagrams } = transport;
  datagrams.outgoingHighWaterMark = MAX_QUEUED;
  datagrams.outgoingMaxAge = MAX_AGE;
  const [streamWriter, datagramWriter] = [writable.getWriter(), datagrams.writable.getWriter()];
  let buffered = 0;
  const gather = createGatherer((frames) => {
    if ((datagramWriter.desiredSize ?? 0) > 0) datagramWriter.write(frames).catch(ignore);
  });
  return {
    get bufferedAmount() {
      return buffered;
    },
    send(data, mayBeLost) {
      if (mayBeLost && data.length <= datagrams.maxDatagramSize) return gather(data, datagrams.maxDatagramSize);
      buffered += data.length;
      streamWriter.write(data).then(() => (buffered -= data.length), ignore);
    },
    close(isImmediate) {
      if (isImmediate) return transport.close();
      // The server ends the session when the stream ends. If the page ended it, the stream's last bytes could get lost.
      streamWriter.close().catch(ignore);
      withTimeout(CLOSE_TIMEOUT, closed).catch(() => transport.close());
    },
  };
}

/** Combines the frames of a task into as few datagrams as possible, which are passed to `write`. */
export function createGatherer(write: (frames: Uint8Array) => void): (frame: Uint8Array, maxBytes: number) => void {
  let frames: Uint8Array[] = [];
  let length = 0;
  function flush(): void {
    if (length === 0) return;
    const datagram = concatBytes(frames);
    [frames, length] = [[], 0];
    write(datagram);
  }
  return (frame, maxBytes) => {
    if (length + frame.length > maxBytes) flush();
    if (length === 0) queueMicrotask(flush);
    frames.push(frame);
    length += frame.length;
  };
}

/** Splits a stream into whole frames. */
export function createSplitter(onFrames: (frames: ArrayBuffer) => void): (piece: Uint8Array) => void {
  let partial: Uint8Array = new Uint8Array();
  return (piece) => {
    const all = concatBytes([partial, piece]);
    const view = new DataView(all.buffer);
    let end = 0;
    while (end + HEADER_BYTES <= all.length) {
      const next = end + HEADER_BYTES + view.getUint16(end + 1, true);
      if (next > all.length) break;
      end = next;
    }
    partial = all.slice(end);
    if (end > 0) onFrames(all.buffer.slice(0, end));
  };
}

/** Reads a stream to its end, and passes its data to `take`. Errors of `take` are reported, and reading continues. */
export async function readAll(readable: ReadableStream, take: (bytes: Uint8Array) => void): Promise<void> {
  const reader = readable.getReader();
  for (;;) {
    const { done, value } = await reader.read().catch(() => ({ done: true, value: undefined }));
    if (done) return;
    try {
      take(value);
    } catch (error) {
      reportError(error);
    }
  }
}

function withTimeout<T>(seconds: number, promise: Promise<T>): Promise<T> {
  const timeout = new AbortController();
  const timer = setTimeout(() => timeout.abort(new Error('the server does not answer')), 1000 * seconds);
  const settled = abortable<T>(timeout.signal, (fulfil, fail) => void promise.then(fulfil, fail));
  return settled.finally(() => clearTimeout(timer));
}

function ignore(): void {
  // The session reports its end itself.
}
