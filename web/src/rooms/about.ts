/** Server's description of its rooms. */

import { bytesOf } from '../hex';

/** Hexadecimal digits of a SHA-256. */
const HASH = /^[0-9a-f]{64}$/;
/** Timeout of the server's answer, milliseconds, after which the room is joined without it. */
const ANSWERS = 3000;

export interface About {
  /** Whether pages may exchange files. */
  readonly peers: boolean;
  /** Endpoint for datagrams; null for none. */
  readonly datagrams: Datagrams | null;
}

export interface Datagrams {
  readonly port: number;
  /** SHA-256 of self-signed certificates. */
  readonly hashes: readonly Uint8Array<ArrayBuffer>[];
}

/** Requests the server's description; null if there is none. */
export type Ask = () => Promise<About | null>;

/** Requests the description from the server of a page, with a signal that ends the wait. */
export async function askAbout(page: string, signal = AbortSignal.timeout(ANSWERS)): Promise<About | null> {
  try {
    const answer = await fetch(new URL('rooms', page), { cache: 'no-store', signal });
    return answer.ok ? readAbout(await answer.json()) : null;
  } catch {
    return null;
  }
}

/** Parses a description; null if it is malformed. */
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
