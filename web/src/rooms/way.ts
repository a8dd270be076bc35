/** Choice of the transport to rooms: datagrams if both sides support them, else a WebSocket. */
import { CLOCK, type Clock } from './clock';
import { openDatagrams } from './datagrams';
import { type Ask, BROKEN_CODE, type Datagrams, type Listener, type Open, openSocket, type Socket } from './server';

/** Seconds for which datagrams are not tried again after a failure. */
const FORGETS = 60;

export interface Transports {
  /** Returns the server's endpoint for datagrams; null for none. */
  readonly datagrams: () => Promise<Datagrams | null>;
  readonly openDatagrams: (relay: string, to: Datagrams, listener: Listener) => Promise<Socket>;
  readonly openSocket: Open;
}

/**
 * Opens sockets by a transport that the server supports. A failed endpoint for datagrams is not tried again for a
 * minute.
 */
export function createOpen(ask: Ask, isOff: boolean, ways: Transports = browserTransports(ask), clock: Clock = CLOCK): Open {
  let failed = '';
  let failedAt = -Infinity;

  async function find(url: string, listener: Listener): Promise<Found> {
    // The server may have a new certificate each time.
    const to = isOff ? null : await ways.datagrams();
    if (to && (nameOf(to) !== failed || clock.now() - failedAt >= FORGETS)) {
      try {
        return { socket: await ways.openDatagrams(url, to, listener), isOpen: true };
      } catch {
        [failed, failedAt] = [nameOf(to), clock.now()];
      }
    }
    return { socket: ways.openSocket(url, listener), isOpen: false };
  }

  return (url, listener) => deferredSocket(find(url, listener), listener);
}

interface Found {
  readonly socket: Socket;
  readonly isOpen: boolean;
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

/** Socket that is resolved later; earlier data are discarded. */
function deferredSocket(opening: Promise<Found>, listener: Listener): Socket {
  let socket: Socket | null = null;
  let isClosed = false;
  function adopt(found: Found): void {
    socket = found.socket;
    if (isClosed) socket.close(true);
    else if (found.isOpen) listener.opened();
  }
  opening.then(adopt, () => listener.closed(BROKEN_CODE));
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
