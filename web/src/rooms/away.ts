/** End of the page, which others see at once, and its return from the browser's cache. */
import type { Connection } from './connection';
import type { TicketStore } from './ticket';

/** On hiding, says bye and stores the ticket; on return from the browser's cache, joins again. */
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
    // The connection still has the ticket.
    tickets.take();
    connection.retry();
  });
}
