/** Whether the pages of a room exchange files: the server and the user must want it, and the browser must be able to. */

/** The parameter by which a user does not. */
const PARAMETER = 'peers';

/** The reason why this page takes no part, by its own address and browser; null for none. */
export function refusalHere(query: URLSearchParams): string | null {
  if (query.get(PARAMETER) === 'off') return 'the address of the page says so';
  if (!globalThis.crypto?.subtle) return 'the browser checks files on https and on this machine alone';
  return typeof RTCPeerConnection === 'function' ? null : 'the browser has no WebRTC';
}

/** The reason of the server beside whose page the rooms are; null for none. */
export async function refusalThere(page: string): Promise<string | null> {
  const silent = 'the server does not tell whether pages may';
  try {
    const answer = await fetch(new URL('rooms', page), { credentials: 'same-origin' });
    if (!answer.ok) return silent;
    const told: unknown = await answer.json();
    if (typeof told !== 'object' || told === null || !('peers' in told)) return silent;
    return told.peers === true ? null : 'the server does not want it';
  } catch {
    return silent;
  }
}
