/**
 * The ticket of a room over a reload of the page, in the tab's own storage. It lies there from the end of a page to the
 * begin of the next one alone: browsers copy the storage into a tab that the user doubles, which is another user.
 */

import { bytesOf, hexOf } from '../hex';

export interface TicketStore {
  /** Take out the ticket that the page before has left; empty if it has left none. */
  take(): Uint8Array;
  put(ticket: Uint8Array): void;
}

/** Where the ticket of a room lies, by the address of its relay without a token. */
export function createTicketStore(relay: string, storage: () => Storage = () => sessionStorage): TicketStore {
  const { origin, pathname } = new URL(relay);
  const key = `nearfar ticket ${origin}${pathname}`;

  /** Browsers may forbid the storage, and it may be full: a ticket is a convenience. */
  function attempt<Result>(action: (storage: Storage) => Result): Result | null {
    try {
      return action(storage());
    } catch {
      return null;
    }
  }

  return {
    take() {
      const text = attempt((found) => found.getItem(key)) ?? '';
      attempt((found) => found.removeItem(key));
      return /^(?:[\da-f]{2}){1,255}$/.test(text) ? bytesOf(text) : new Uint8Array();
    },
    put(ticket) {
      if (ticket.length === 0) return;
      attempt((found) => found.setItem(key, hexOf(ticket)));
    },
  };
}
