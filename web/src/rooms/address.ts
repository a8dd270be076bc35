/** Room that the page's address names, and the address of its relay. */
import { FORBIDDEN, MAX_NAME_BYTES } from './frames';

const [MAX_ROOM_BYTES, MAX_GROUP] = [64, 0xffff] as const;
/** Name of users who give none. */
const DEFAULT_NAME = 'Guest';

export interface Address {
  readonly room: string;
  readonly name: string;
  readonly group: number;
  /** Token for servers that require one; null for none. */
  readonly token: string | null;
}

/** Parses the room of `?room=NAME&name=…&group=…&token=…`; returns a sentence if it is invalid. */
export function readAddress(query: URLSearchParams): Address | string {
  const [room, group] = [query.get('room') ?? '', query.get('group') ?? '0'];
  // Browsers resolve . and .. as folders.
  if (byteLength(room) < 1 || byteLength(room) > MAX_ROOM_BYTES || /[/\p{Cc}]/u.test(room) || /^\.\.?$/.test(room))
    return `room: expected a name of 1 to ${MAX_ROOM_BYTES} bytes without a slash, . and ..`;
  if (!/^\d{1,5}$/.test(group) || Number(group) > MAX_GROUP) return `group: expected a number from 0 to ${MAX_GROUP}`;
  return { room, name: fitName(query.get('name') ?? ''), group: Number(group), token: query.get('token') };
}

/** Address of a room's relay on the server of a page. */
export function relayOf(page: string, { room, token }: Address): string {
  const address = new URL(`rooms/${encodeURIComponent(room)}`, page);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  if (token !== null) address.searchParams.set('token', token);
  return address.href;
}

/** Query parameters of this user only: a token admits one user at a time, and the others are personal choices. */
const PERSONAL_PARAMETERS = ['name', 'token', 'peers', 'datagrams'] as const;

/** Link to the room for other users. */
export function inviteOf(page: string): string {
  const address = new URL(page);
  for (const parameter of PERSONAL_PARAMETERS) address.searchParams.delete(parameter);
  return address.href;
}

/** Truncates a name to the length that a frame can hold. */
function fitName(text: string): string {
  const letters = [...text.replace(new RegExp(FORBIDDEN, 'gu'), '').trim()];
  while (byteLength(letters.join('')) > MAX_NAME_BYTES) letters.pop();
  return letters.join('') || DEFAULT_NAME;
}

/** User's name with its number, because names may be equal or look alike. */
export function displayName(name: string, number: number): string {
  return `${name || DEFAULT_NAME} #${number}`;
}

function byteLength(text: string): number {
  return new TextEncoder().encode(text).length;
}
