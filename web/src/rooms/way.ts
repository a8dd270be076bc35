/** By which way a page comes into rooms: by datagrams where both sides have them, else by WebSocket. */
import type { Ask, Datagrams } from './about';
import { CLOCK, type Clock } from './clock';
import { openDatagrams } from './datagrams';
import { type Listener, type Open, openSocket, type Socket } from './socket';

/** Seconds for which a server that does not answer by datagrams is not asked again. */
const FORGETS = 60;
/** The close code of a WebSocket that broke off. */
const BROKEN = 1006;

export interface Ways {
  /** Where the server takes datagrams; null if nowhere. */
  readonly datagrams: () => Promise<Datagrams | null>;
  readonly openDatagrams: (relay: string, to: Datagrams, listener: Listener) => Promise<Socket>;
  readonly openSocket: Open;
}

/**
 * Open sockets to a server that tells by which ways. What has failed is not tried again for a minute, unless the server
 * tells of something else.
 */
export function createOpen(ask: Ask, isOff: boolean, ways: Ways = browserWays(ask), clock: Clock = CLOCK): Open {
  let failed = '';
  let failedAt = -Infinity;

  async function find(url: string, listener: Listener): Promise<Found> {
    // The server may have another certificate each time.
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

  return (url, listener) => later(find(url, listener), listener);
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
function later(found: Promise<Found>, listener: Listener): Socket {
  let socket: Socket | null = null;
  let isClosed = false;
  function use(one: Found): void {
    socket = one.socket;
    if (isClosed) socket.close(true);
    else if (one.isOpen) listener.opened();
  }
  found.then(use, () => listener.closed(BROKEN));
  return {
    get bufferedAmount() {
      return socket?.bufferedAmount ?? 0;
    },
    send(data, isPassing) {
      socket?.send(data, isPassing);
    },
    close(isAtOnce) {
      isClosed = true;
      socket?.close(isAtOnce);
    },
  };
}
