/** WebTransport for frames: a stream for reliable frames, datagrams for those that a later one replaces. */
import { concatBytes } from '../base/bytes';
import { BROKEN_CODE, CLOSE_TIMEOUT, type Datagrams, type Listener, type Socket } from './server';

/** Timeout for a connection, seconds: networks that drop UDP report nothing. */
const READY = 3;
/** Greatest number of queued datagrams, and their greatest age in milliseconds; others are dropped. */
const [WAITING, OLDEST] = [4, 50] as const;
/** Bytes of a frame's header; the last two are the length of the body. */
const HEAD = 3;

/** Connects to the server's port for datagrams. Rejects on failure; the listener is not called before it resolves. */
export async function openDatagrams(relay: string, to: Datagrams, listener: Listener): Promise<Socket> {
  const transport = new WebTransport(addressOf(relay, to), {
    congestionControl: 'low-latency',
    serverCertificateHashes: to.hashes.map((value) => ({ algorithm: 'sha-256', value })),
  });
  const closed = transport.closed.then(
    ({ closeCode }) => closeCode || BROKEN_CODE,
    () => BROKEN_CODE,
  );
  try {
    const stream = await withTimeout(READY, openStream(transport));
    // Nothing is reported of a session that fails, as in browsers with another version of WebTransport.
    const socket = sending(transport, stream.writable, closed);
    void closed.then((code) => listener.closed(code));
    void readAll(stream.readable, splitter((frames) => listener.received(frames)));
    void readAll(transport.datagrams.readable, (datagram) => listener.received(datagram.slice().buffer));
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

async function openStream(transport: WebTransport): Promise<WebTransportBidirectionalStream> {
  await transport.ready;
  return transport.createBidirectionalStream();
}

function sending(transport: WebTransport, writable: WritableStream, closed: Promise<unknown>): Socket {
  const { datagrams } = transport;
  datagrams.outgoingHighWaterMark = WAITING;
  datagrams.outgoingMaxAge = OLDEST;
  const [stream, passing] = [writable.getWriter(), datagrams.writable.getWriter()];
  let bytes = 0;
  const gather = gatherer((frames) => {
    if ((passing.desiredSize ?? 0) > 0) passing.write(frames).catch(ignore);
  });
  return {
    get bufferedAmount() {
      return bytes;
    },
    send(data, mayBeLost) {
      if (mayBeLost && data.length <= datagrams.maxDatagramSize) {
        gather(data, datagrams.maxDatagramSize);
        return;
      }
      bytes += data.length;
      stream.write(data).then(() => (bytes -= data.length), ignore);
    },
    close(isImmediate) {
      if (isImmediate) {
        transport.close();
        return;
      }
      // The server ends the session at the stream's end. If the page did, the last bytes of the stream could be lost.
      stream.close().catch(ignore);
      withTimeout(CLOSE_TIMEOUT, closed).catch(() => transport.close());
    },
  };
}

/** Combines the frames of one task into one datagram, or several if they are too large, each passed to `write`. */
export function gatherer(write: (frames: Uint8Array) => void): (frame: Uint8Array, most: number) => void {
  let frames: Uint8Array[] = [];
  let length = 0;
  function flush(): void {
    if (length === 0) return;
    const all = concatBytes(frames);
    [frames, length] = [[], 0];
    write(all);
  }
  return (frame, most) => {
    if (length + frame.length > most) flush();
    if (length === 0) queueMicrotask(flush);
    frames.push(frame);
    length += frame.length;
  };
}

/** Splits a stream into whole frames. */
export function splitter(give: (frames: ArrayBuffer) => void): (piece: Uint8Array) => void {
  let rest: Uint8Array = new Uint8Array();
  return (piece) => {
    const all = concatBytes([rest, piece]);
    const view = new DataView(all.buffer);
    let whole = 0;
    while (whole + HEAD <= all.length) {
      const next = whole + HEAD + view.getUint16(whole + 1, true);
      if (next > all.length) break;
      whole = next;
    }
    rest = all.slice(whole);
    if (whole > 0) give(all.buffer.slice(0, whole));
  };
}

/** Reads to the end, which the session reports itself. Errors of `take` are reported and do not end the reading. */
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

async function withTimeout<T>(seconds: number, promise: Promise<T>): Promise<T> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const late = new Promise<never>((_, reject) => {
    timer = setTimeout(() => reject(new Error('the server does not answer')), 1000 * seconds);
  });
  try {
    return await Promise.race([promise, late]);
  } finally {
    clearTimeout(timer);
  }
}

function ignore(): void {
  // The session reports its end itself.
}
