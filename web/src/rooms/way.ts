/** By which way a page comes into rooms: by datagrams where both sides have them, else by WebSocket. */
import type { Ask, Datagrams } from './about';
import { openDatagrams } from './datagrams';
import { type Listener, type Open, openSocket, type Socket } from './socket';

export interface Ways {
  /** Where the server takes datagrams; null if nowhere. */
  readonly datagrams: () => Promise<Datagrams | null>;
  readonly openDatagrams: (relay: string, to: Datagrams, listener: Listener) => Promise<Socket>;
  readonly openSocket: Open;
}

/** Open sockets to a server that tells by which ways. What has failed is not tried again until it tells of something else. */
export function createOpen(ask: Ask, isOff: boolean, ways: Ways = browserWays(ask)): Open {
  let failed = '';

  async function find(url: string, listener: Listener): Promise<Found> {
    // The server may have another certificate each time.
    const to = isOff ? null : await ways.datagrams();
    if (to && nameOf(to) !== failed) {
      try {
        return { socket: await ways.openDatagrams(url, to, listener), isOpen: true };
      } catch {
        failed = nameOf(to);
      }
    }
    return { socket: ways.openSocket(url, listener), isOpen: false };
  }

  return (url, listener) => later(find(url, listener), () => listener.opened());
}

interface Found {
  readonly socket: Socket;
  readonly isOpen: boolean;
}

function nameOf({ port, hashes }: Datagrams): string {
  return `${port} ${hashes.join(' ')}`;
}

function browserWays(ask: Ask): Ways {
  return {
    async datagrams() {
      if (typeof WebTransport === 'undefined') return null;
      return (await ask())?.datagrams ?? null;
    },
    openDatagrams,
    openSocket,
  };
}

/** A socket that is found later; until then nothing can be sent. */
function later(found: Promise<Found>, opened: () => void): Socket {
  let socket: Socket | null = null;
  let isClosed = false;
  void found.then((one) => {
    socket = one.socket;
    if (isClosed) socket.close();
    else if (one.isOpen) opened();
  });
  return {
    get bufferedAmount() {
      return socket?.bufferedAmount ?? 0;
    },
    send(data, isPassing) {
      socket?.send(data, isPassing);
    },
    close() {
      isClosed = true;
      socket?.close();
    },
  };
}
