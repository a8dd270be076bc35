/** What the server tells of its rooms. */

/** Digits of a hash. */
const HASH = /^[0-9a-f]{64}$/;

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

/** What the server tells; null if it does not. */
export type Ask = () => Promise<About | null>;

/** Ask the server beside a page. */
export async function askAbout(page: string): Promise<About | null> {
  try {
    const answer = await fetch(new URL('rooms', page), { cache: 'no-store' });
    return answer.ok ? readAbout(await answer.json()) : null;
  } catch {
    return null;
  }
}

/** What a server has told; null if it is of another form. */
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

function bytesOf(digits: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(digits.match(/../g) ?? [], (pair) => parseInt(pair, 16));
}

function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null;
}
