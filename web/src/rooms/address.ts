/** The room that the address of the page names, and the address of its relay. */
import { HIDDEN, NAME } from './frames';

/** Most bytes of a room's name, and the greatest number of a group. */
const [ROOM, GROUP] = [64, 0xffff] as const;
/** The name of those who tell none. */
const NOBODY = 'Guest';

export interface Address {
  readonly room: string;
  readonly name: string;
  readonly group: number;
  /** Lets into rooms of a server that wants one; null for none. */
  readonly token: string | null;
}

/** The room of `?room=NAME&name=…&group=…&token=…`; a sentence if it names none that there can be. */
export function readAddress(query: URLSearchParams): Address | string {
  const [room, group] = [query.get('room') ?? '', query.get('group') ?? '0'];
  // The browser takes . and .. for folders.
  if (sizeOf(room) < 1 || sizeOf(room) > ROOM || /[/\p{Cc}]/u.test(room) || /^\.\.?$/.test(room)) {
    return `room: expected a name of 1 to ${ROOM} bytes without a slash, . and ..`;
  }
  if (!/^\d{1,5}$/.test(group) || Number(group) > GROUP) return `group: expected a number from 0 to ${GROUP}`;
  return { room, name: nameOf(query.get('name') ?? ''), group: Number(group), token: query.get('token') };
}

/** The relay of a room beside a page. */
export function relayOf(page: string, { room, token }: Address): string {
  const address = new URL(`rooms/${encodeURIComponent(room)}`, page);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  if (token !== null) address.searchParams.set('token', token);
  return address.href;
}

/** Parts of a page's address for its own user: a token is of use to one at a time, and others choose for themselves. */
const OWN = ['name', 'token', 'peers', 'datagrams'] as const;

/** A link to the room for others. */
export function inviteOf(page: string): string {
  const address = new URL(page);
  for (const own of OWN) address.searchParams.delete(own);
  return address.href;
}

/** As much of a name as a frame can hold. */
function nameOf(wanted: string): string {
  const letters = [...wanted.replace(new RegExp(HIDDEN, 'gu'), '').trim()];
  while (sizeOf(letters.join('')) > NAME) letters.pop();
  return letters.join('') || NOBODY;
}

/** A user's name with its number, since users may have the same name, or one that looks the same. */
export function shownName(name: string, number: number): string {
  return `${name || NOBODY} #${number}`;
}

function sizeOf(text: string): number {
  return new TextEncoder().encode(text).length;
}
