/** Conditions for exchanging files between pages of a room: server, user and browser must allow it. */
import type { ServerDescription } from '../rooms/server';
import { onStorage } from '../rooms/ticket';

/** Key of the user's choice in the storage; without an entry, files are exchanged. */
const STORAGE_KEY = 'nearfar peers';

type Choice = ReturnType<typeof createChoice>;

export function createChoice(storage: () => Storage = () => localStorage) {
  // If the browser forbids storage, the choice holds for this page only.
  let isOn = onStorage(storage, (store) => store.getItem(STORAGE_KEY)) !== 'off';
  return {
    get isOn(): boolean {
      return isOn;
    },
    set(isWanted: boolean): void {
      isOn = isWanted;
      onStorage(storage, (store) => (isWanted ? store.removeItem(STORAGE_KEY) : store.setItem(STORAGE_KEY, 'off')));
    },
  };
}

const QUERY_PARAMETER = 'peers';
export const SWITCHED_OFF = 'the user has switched it off';

/** Returns why this page's address, user or browser prevents the exchange; null if nothing does. */
export function refusalOfPage(query: URLSearchParams, choice: Choice): string | null {
  if (query.get(QUERY_PARAMETER) === 'off') return 'the address of the page switches it off';
  if (!choice.isOn) return SWITCHED_OFF;
  if (!globalThis.crypto?.subtle) return 'the browser hashes files only on https and on localhost';
  return typeof RTCPeerConnection === 'function' ? null : 'the browser has no WebRTC';
}

/** Returns why the server prevents the exchange; null if it allows it. */
export function refusalOfServer(description: ServerDescription | null): string | null {
  if (!description) return 'the server does not say whether it allows it';
  return description.peers ? null : 'the server does not allow it';
}
