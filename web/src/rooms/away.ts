/** The end of the page, which others shall see at once, and its return from the browser's cache. */
import type { Connection } from './connection';
import type { TicketStore } from './ticket';

/** A page that goes says bye and leaves its ticket; one that the browser has kept joins again. */
export function followPage(connection: Connection, tickets: TicketStore, page: EventTarget = window): void {
  let isAway = false;
  page.addEventListener('pagehide', () => {
    if (connection.state.kind === 'ended') return;
    tickets.put(connection.ticket);
    connection.leave(true);
    isAway = true;
  });
  page.addEventListener('pageshow', () => {
    if (!isAway) return;
    isAway = false;
    // The connection has its ticket.
    tickets.take();
    connection.retry();
  });
}
