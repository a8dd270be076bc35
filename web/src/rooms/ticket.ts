/**
 * Ticket of a room, stored in the tab's session storage while the page is reloaded. It is not stored any longer,
 * because browsers copy the storage into a duplicated tab, which is another user.
 */
import { bytesOf, hexOf } from '../base/bytes';
import type { Connection } from './connection';

type TicketStore = ReturnType<typeof createTicketStore>;

/** Performs an action on a storage; returns null if the browser forbids it or the storage is full. */
export function onStorage<Result>(storage: () => Storage, action: (storage: Storage) => Result): Result | null {
  try {
    return action(storage());
  } catch {
    return null;
  }
}

/** Creates the store of a room's ticket; its key is the address of the relay without a token. */
export function createTicketStore(relay: string, storage: () => Storage = () => sessionStorage) {
  const { origin, pathname } = new URL(relay);
  const key = `nearfar ticket ${origin}${pathname}`;

  return {
    /** Removes and returns the ticket of the previous page; empty if there is none. */
    take(): Uint8Array {
      const text = onStorage(storage, (store) => store.getItem(key)) ?? '';
      onStorage(storage, (store) => store.removeItem(key));
      return /^(?:[\da-f]{2}){1,255}$/.test(text) ? bytesOf(text) : new Uint8Array();
    },
    put(ticket: Uint8Array): void {
      if (ticket.length === 0) return;
      onStorage(storage, (store) => store.setItem(key, hexOf(ticket)));
    },
  };
}

/** Stores the ticket and leaves when the page is hidden; joins again when it returns from the browser's cache. */
export function followPage(connection: Connection, tickets: TicketStore, page: EventTarget = window): void {
  let hasLeft = false;
  page.addEventListener('pagehide', () => {
    if (connection.state.kind === 'ended') return;
    tickets.put(connection.ticket);
    connection.leave(true);
    hasLeft = true;
  });
  page.addEventListener('pageshow', () => {
    if (!hasLeft) return;
    hasLeft = false;
    // The connection still has the ticket, so that the stored copy is only removed.
    tickets.take();
    connection.retry();
  });
}
