/** Whether the pages of a room exchange files: server and user must want it, and the browser must be able to. */
import type { About } from '../rooms/about';
import type { Choice } from './choice';

/** The parameter by which a user does not. */
const PARAMETER = 'peers';
/** The reason of who has switched it off. */
export const UNWANTED = 'the user does not want it';

/** The reason why this page takes no part, by its own address and browser; null for none. */
export function refusalHere(query: URLSearchParams, choice: Choice): string | null {
  if (query.get(PARAMETER) === 'off') return 'the address of the page says so';
  if (!choice.isOn) return UNWANTED;
  if (!globalThis.crypto?.subtle) return 'the browser checks files on https and on this machine alone';
  return typeof RTCPeerConnection === 'function' ? null : 'the browser has no WebRTC';
}

/** The reason of the server, by what it tells; null for none. */
export function refusalThere(about: About | null): string | null {
  if (!about) return 'the server does not tell whether pages may';
  return about.peers ? null : 'the server does not want it';
}
