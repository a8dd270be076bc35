/** Interface of a socket for frames: a WebSocket or an equivalent. */

/** Timeout in seconds for the server to close the connection after a user has left, which frees the user's seat. */
export const CLOSING = 5;

export interface Socket {
  /** Number of buffered bytes. */
  readonly bufferedAmount: number;
  /** Sends a frame; `isPassing` allows its loss because a later frame replaces it. */
  send(data: Uint8Array<ArrayBuffer>, isPassing: boolean): void;
  /** Closes after all sent frames, or at once; `closed` is called when the server has closed, too. */
  close(isAtOnce: boolean): void;
}

/** Listener of a socket; not called before the socket is returned. */
export interface Listener {
  opened(): void;
  /** Called with whole frames as an ArrayBuffer, or with malformed data. */
  came(data: unknown): void;
  /** Called with a WebSocket close code. */
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
