/**
 * Source of each file: this page's store, another page that has the file or is receiving it, or the server. Of the
 * connected pages that need a file, one requests it from the server. Pages never wait for each other in a circle: a
 * page requests a file only from pages that have it, receive it from the server, or have a greater weight for it.
 */
import { LruCache } from '../base/cache';
import { abortable } from '../base/errors';
import type { FileEntry } from '../bundle/manifest';
import type { Received, Serve } from '../bundle/source';
import { sha256 } from '../base/bytes';
import type { Answer } from './downloads';
import type { Holding } from './messages';
import type { Peer } from './peer';

/**
 * Timeouts for another page, during and after the first picture. Pages with software rendering answer about once a
 * second: with a quiet timeout of 1 s, the server sent more than twice the files of one page in one run of four.
 */
const FIRST_PICTURE = { quietTimeout: 3, requestTimeout: 5, minRate: 1e6 } as const;
const AFTER_FIRST_PICTURE = { quietTimeout: 4, requestTimeout: 10, minRate: 65_536 } as const;
/** Number of users who time out during the first picture after which the server alone sends its files. */
const MAX_TIMED_OUT_USERS = 2;

export interface ShareSettings {
  /** Files that the page can send to others, by key; browsers may keep blobs on disk. */
  readonly store: LruCache<Blob>;
  readonly entryOf: (name: string) => FileEntry | undefined;
  /** Names of the files that the page shows or will show. */
  readonly shownNames: () => Iterable<string>;
  /** Whether the first picture is still missing. */
  readonly isFirstPictureMissing: () => boolean;
  /** User's own number; null outside the room. */
  readonly ownNumber: () => number | null;
  readonly peers: () => readonly Peer[];
  /** Resolves when all initial neighbours have sent their lists of files, or after a timeout. */
  readonly ready: Promise<void>;
  /** Fetches a file from any source; called if another page requests it before this page does. */
  readonly fetch: (name: string, signal: AbortSignal) => Promise<ArrayBuffer>;
}

export type Share = ReturnType<typeof createShare>;

export function createShare(settings: ShareSettings) {
  const { store, entryOf, shownNames, isFirstPictureMissing, ownNumber, peers, ready, fetch } = settings;
  /** Bytes and files received from other pages, and from the server. */
  const counts = { others: { bytes: 0, files: 0 }, server: { bytes: 0, files: 0 } };
  /** Received bytes of each file in transfer; files requested from the server. */
  const arrivedBytes = new Map<string, number>();
  const requested = new Set<string>();
  const timedOutUsers = new Set<number>();

  /** Returns the page to request a file from; null for the server. */
  function choosePeer(key: string, tried: ReadonlySet<number>): Peer | null {
    const number = ownNumber();
    const isUrgent = isFirstPictureMissing();
    if (number === null || (isUrgent && timedOutUsers.size >= MAX_TIMED_OUT_USERS)) return null;
    const isExcluded = (user: number): boolean => tried.has(user) || (isUrgent && timedOutUsers.has(user));
    const free = peers().filter((peer) => peer.isFree && !peer.awaits(key) && !isExcluded(peer.number));
    const compareWeights = (a: Peer, b: Peer): number => (precedes(a.number, b.number, key) ? -1 : 1);
    const findLeastBusy = (holding: Holding): Peer | undefined =>
      free
        .filter((peer) => peer.holdingOf(key) === holding)
        .sort((a, b) => a.openCount - b.openCount || compareWeights(a, b))[0];
    const [firstByWeight] = free.filter((peer) => precedes(peer.number, number, key)).sort(compareWeights);
    return findLeastBusy('here') ?? findLeastBusy('coming') ?? firstByWeight ?? null;
  }

  async function fetchFromOthers(
    file: FileEntry,
    signal: AbortSignal,
    received: Received,
  ): Promise<ArrayBuffer | null> {
    const { sha256: key } = file;
    const isKnown = peers().some((peer) => peer.holdingOf(key) !== 'gone');
    if (!isKnown) await abortable<void>(signal, (done, failed) => void ready.then(done, failed));
    const tried = new Set<number>();
    for (let peer = choosePeer(key, tried); peer; peer = choosePeer(key, tried)) {
      tried.add(peer.number);
      const timeouts = isFirstPictureMissing() ? FIRST_PICTURE : AFTER_FIRST_PICTURE;
      const answer: Answer = await peer.request({ ...file, ...timeouts }, signal, received);
      if (answer instanceof ArrayBuffer) return answer;
      // A file of the first picture waits for only one page.
      if (answer === 'silent' && isFirstPictureMissing()) {
        timedOutUsers.add(peer.number);
        return null;
      }
    }
    return null;
  }

  async function fetchFromServer(key: string, serve: () => Promise<ArrayBuffer>): Promise<ArrayBuffer> {
    requested.add(key);
    for (const peer of peers()) peer.tell('coming', [key]);
    try {
      const data = await serve();
      // Damaged data are not sent to other pages; the decoder reports them.
      if ((await sha256(data)) === key) addToStore(key, data);
      return data;
    } finally {
      requested.delete(key);
      if (!store.has(key)) for (const peer of peers()) peer.tell('gone', [key]);
    }
  }

  function addToStore(key: string, data: ArrayBuffer): void {
    const evicted = data.byteLength > store.maxBytes ? [] : store.add(key, new Blob([data]), data.byteLength);
    for (const peer of peers()) {
      if (evicted.length > 0) peer.tell('gone', evicted);
      if (store.has(key)) peer.tell('here', [key]);
    }
  }

  return {
    counts,
    /** Returns a file's content; `serve` requests it from the server. */
    async get(name: string, signal: AbortSignal, received: Received, serve: Serve): Promise<ArrayBuffer> {
      const file = entryOf(name);
      // `serve` reports an unlisted file.
      if (!file || file.bytes === 0) return serve(name, signal, received);
      const { sha256: key } = file;
      const storedData = await store.get(key)?.arrayBuffer().catch(() => null);
      if (storedData) {
        received(storedData.byteLength);
        return storedData;
      }
      const countBytes = (source: 'others' | 'server'): Received => (bytes) => {
        arrivedBytes.set(key, (arrivedBytes.get(key) ?? 0) + bytes);
        counts[source].bytes += bytes;
        received(bytes);
      };
      arrivedBytes.set(key, 0);
      try {
        const peerData = await fetchFromOthers(file, signal, countBytes('others'));
        if (peerData) addToStore(key, peerData);
        const data = peerData ?? (await fetchFromServer(key, () => serve(name, signal, countBytes('server'))));
        counts[peerData ? 'others' : 'server'].files += 1;
        return data;
      } finally {
        arrivedBytes.delete(key);
        for (const peer of peers()) peer.settle(key);
      }
    },
    /** Sends a newly connected page the lists of files that this page has or is receiving from the server. */
    sendFiles(peer: Peer): void {
      peer.tell('coming', [...requested]);
      peer.tell('here', store.keys);
    },
    shelf: {
      find: (key: string) => store.get(key) ?? null,
      sizeOf: (key: string) => Math.max(arrivedBytes.get(key) ?? 0, 0),
      obtain(key: string): boolean {
        if (arrivedBytes.has(key)) return true;
        for (const name of shownNames()) {
          if (entryOf(name)?.sha256 !== key) continue;
          fetch(name, new AbortController().signal).catch(() => {
            for (const peer of peers()) peer.settle(key);
          });
          return true;
        }
        return false;
      },
    },
  };
}

/**
 * Whether user a precedes user b for a file. By rendezvous hashing all users agree on weights, and the user with the
 * greatest weight requests the file from the server. The key is a SHA-256 in hexadecimal digits.
 */
export function precedes(a: number, b: number, key: string): boolean {
  const [weightA = 0, weightB = 0] = [a, b].map((user) => mixBits(mixBits(user + 1) ^ parseInt(key.slice(0, 8), 16)));
  const difference = weightA - weightB;
  return difference > 0 || (difference === 0 && a < b);
}

/** Finaliser of MurmurHash3. */
function mixBits(number: number): number {
  let hash = number >>> 0;
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return (hash ^ (hash >>> 16)) >>> 0;
}
