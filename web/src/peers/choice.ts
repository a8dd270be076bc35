/** Conditions for exchanging files between pages of a room: server, user and browser must allow it. */
import type { About } from '../rooms/server';
import { onStorage } from '../rooms/ticket';

/** Key of the choice in the storage; without an entry files are exchanged. */
const KEY = 'nearfar peers';

export interface Choice {
  readonly isOn: boolean;
  set(isOn: boolean): void;
}

export function createChoice(storage: () => Storage = () => localStorage): Choice {
  // Without a storage the choice holds for this page only.
  let isOn = onStorage(storage, (found) => found.getItem(KEY)) !== 'off';
  return {
    get isOn() {
      return isOn;
    },
    set(wanted) {
      isOn = wanted;
      onStorage(storage, (found) => (wanted ? found.removeItem(KEY) : found.setItem(KEY, 'off')));
    },
  };
}

/** Query parameter by which a user declines. */
const PARAMETER = 'peers';
/** Reason if the user has switched it off. */
export const UNWANTED = 'the user has switched it off';

/** Returns why this page's address, user or browser prevents the exchange; null if nothing does. */
export function refusalHere(query: URLSearchParams, choice: Choice): string | null {
  if (query.get(PARAMETER) === 'off') return 'the address of the page switches it off';
  if (!choice.isOn) return UNWANTED;
  if (!globalThis.crypto?.subtle) return 'the browser hashes files only on https and on localhost';
  return typeof RTCPeerConnection === 'function' ? null : 'the browser has no WebRTC';
}

/** Returns why the server prevents the exchange; null if it allows it. */
export function refusalThere(about: About | null): string | null {
  if (!about) return 'the server does not say whether it allows it';
  return about.peers ? null : 'the server does not allow it';
}
