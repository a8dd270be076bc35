/** The way by which frames come and go: a WebSocket, or what does the same. */

/** Seconds for which a server may let a user wait who has left. When it closes, the user's seat is free. */
export const CLOSING = 5;

export interface Socket {
  /** Bytes that wait to be sent. */
  readonly bufferedAmount: number;
  /** Send a frame; `isPassing` if a later one replaces it, so that it may get lost. */
  send(data: Uint8Array<ArrayBuffer>, isPassing: boolean): void;
  /** Close it after all that was sent, or at once; `closed` is told when the server has closed it, too. */
  close(isAtOnce: boolean): void;
}

/** Whoever listens to a socket; nothing is told before the socket is returned. */
export interface Listener {
  opened(): void;
  /** Whole frames have come, as an ArrayBuffer, or what is no such thing. */
  came(data: unknown): void;
  /** A close code of WebSocket. */
  closed(code: number): void;
}

export type Open = (url: string, listener: Listener) => Socket;

export function openSocket(url: string, listener: Listener): Socket {
  const socket = new WebSocket(url);
  socket.binaryType = 'arraybuffer';
  socket.onopen = () => listener.opened();
  socket.onmessage = ({ data }) => listener.came(data);
  socket.onclose = ({ code }) => listener.closed(code);
  return {
    get bufferedAmount() {
      return socket.bufferedAmount;
    },
    send: (data) => socket.send(data),
    close: () => socket.close(),
  };
}
