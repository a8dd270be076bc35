/** Reasons for the end of a connection to a room, in words. */

/** Codes of the reasons in docs/rooms.md. */
const REASON = {
  version: 2,
  frame: 3,
  token: 4,
  full: 5,
  flood: 6,
  slow: 7,
  silent: 8,
  replaced: 9,
  ending: 10,
} as const;
/** Offset from a reason's code to its WebSocket close code. */
const OWN = 4000;

const WORDS: Readonly<Record<number, string>> = {
  [REASON.version]: 'The server has another version of rooms than this page. Reload the page.',
  [REASON.frame]: 'The server does not understand what this page sends.',
  [REASON.token]: 'This link does not let you into the room. Ask for another one.',
  [REASON.full]: 'The room is full.',
  [REASON.flood]: 'This page has sent more than the server takes.',
  [REASON.slow]: 'The connection is too slow for this room.',
  [REASON.silent]: 'The server has not heard from this page.',
  [REASON.replaced]: 'You have entered the room elsewhere.',
  [REASON.ending]: 'The server ends.',
};
/** Reasons after which a reconnection would not help. */
const FINAL: ReadonlySet<number> = new Set([REASON.version, REASON.token, REASON.replaced]);

/** End of a connection. */
export interface End {
  readonly words: string;
  /** Whether a retry is useless. */
  readonly isFinal: boolean;
}

/** Returns the end for a reason's code. */
export function endOf(reason: number): End {
  return { words: WORDS[reason] ?? 'The room has ended the connection.', isFinal: FINAL.has(reason) };
}

/** Returns the end for a WebSocket close code; `wasIn` if the user was in the room. */
export function endOfCode(code: number, wasIn: boolean): End {
  if (code > OWN) return endOf(code - OWN);
  return { words: wasIn ? 'The connection to the room broke off.' : 'The room cannot be reached.', isFinal: false };
}
