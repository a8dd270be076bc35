/** The server's answer to who asks for its rooms. */

import { bytesOf } from '../hex';

/** Digits of a hash. */
const HASH = /^[0-9a-f]{64}$/;
/** Milliseconds in which the server must answer; a page does not wait longer for the room. */
const ANSWERS = 3000;

export interface About {
  /** Pages may exchange files among themselves. */
  readonly peers: boolean;
  /** Where datagrams are taken; null if nowhere. */
  readonly datagrams: Datagrams | null;
}

export interface Datagrams {
  readonly port: number;
  /** SHA-256 of certificates that no authority has signed. */
  readonly hashes: readonly Uint8Array<ArrayBuffer>[];
}

/** Ask what the server tells; null if it tells nothing. */
export type Ask = () => Promise<About | null>;

/** Ask the server beside a page, by a signal that ends the wait for it. */
export async function askAbout(page: string, signal = AbortSignal.timeout(ANSWERS)): Promise<About | null> {
  try {
    const answer = await fetch(new URL('rooms', page), { cache: 'no-store', signal });
    return answer.ok ? readAbout(await answer.json()) : null;
  } catch {
    return null;
  }
}

/** Read what a server has told; null if it is of another form. */
export function readAbout(told: unknown): About | null {
  if (!isRecord(told) || typeof told['peers'] !== 'boolean') return null;
  const { peers, datagrams } = told;
  return { peers, datagrams: isRecord(datagrams) ? readDatagrams(datagrams) : null };
}

function readDatagrams({ port, hashes }: Readonly<Record<string, unknown>>): Datagrams | null {
  const isPort = Number.isInteger(port) && Number(port) > 0 && Number(port) < 1 << 16;
  const areHashes = Array.isArray(hashes) && hashes.every((hash) => typeof hash === 'string' && HASH.test(hash));
  if (!isPort || !areHashes) return null;
  return { port: Number(port), hashes: hashes.map(bytesOf) };
}

function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null;
}
