/** Pages that exchange files over channels in memory, on a clock that the test advances. */
import { createHash } from 'node:crypto';
import type { FileEntry } from '../../src/bundle/manifest';
import { TICK } from '../../src/peers/downloads';
import { type Channel, createPeer, type Peer } from '../../src/peers/peer';
import { createShare, type Share } from '../../src/peers/share';
import { LruCache } from '../../src/base/cache';
import { createBudget } from '../../src/peers/uploads';
import type { Bucket, Clock } from '../../src/rooms/clock';
import { createSteppedClock } from './clock';

export type Stepped = ReturnType<typeof steppedClock>;

/** Creates a clock whose ticks call actions and await pending work. */
export function steppedClock() {
  const { advance, ...clock } = createSteppedClock();
  const actions: (() => void)[] = [];
  return {
    ...clock,
    /** Calls a function at each tick. */
    each: (action: () => void): void => void actions.push(action),
    /** Advances by some seconds, in ticks. */
    async advance(seconds: number): Promise<void> {
      for (let remaining = seconds; remaining > 1e-9; remaining -= TICK) {
        advance(Math.min(TICK, remaining));
        for (const action of actions) action();
        await waitUntilIdle();
      }
    },
  };
}

/** Number of hashes that worker threads are computing, in real time. */
let pendingHashes = 0;
const digest = crypto.subtle.digest.bind(crypto.subtle);
crypto.subtle.digest = async (...parameters) => {
  pendingHashes += 1;
  try {
    return await digest(...parameters);
  } finally {
    pendingHashes -= 1;
  }
};

/** Waits until no hashes are pending, and then for some turns of the event loop. */
export async function waitUntilIdle(turns = 60): Promise<void> {
  for (let turn = 0; turn < turns; turn = pendingHashes > 0 ? 0 : turn + 1) await new Promise((done) => setImmediate(done));
}

/** End of a channel in memory. Sent data reach the other end later, in order. */
export class Wire implements Channel {
  binaryType: BinaryType = 'blob';
  bufferedAmount = 0;
  bufferedAmountLowThreshold = 0;
  onmessage: Channel['onmessage'] = null;
  onbufferedamountlow: Channel['onbufferedamountlow'] = null;
  other: Wire | null = null;
  isClosed = false;
  /** Whether sent data are held back in the buffer. */
  isHeld = false;
  readonly sent: Uint8Array[] = [];

  send(data: unknown): void {
    if (this.isClosed) throw new Error('the channel is closed');
    const bytes = (data as Uint8Array).slice();
    this.sent.push(bytes);
    if (this.isHeld) this.bufferedAmount += bytes.length;
    else setImmediate(() => this.other?.receive(bytes.buffer));
  }

  receive(data: unknown): void {
    if (!this.isClosed) this.onmessage?.call(this as unknown as RTCDataChannel, { data } as MessageEvent);
  }

  /** Empties the buffer; data that are sent from then on are delivered. */
  drain(): void {
    this.isHeld = false;
    this.bufferedAmount = 0;
    this.onbufferedamountlow?.call(this as unknown as RTCDataChannel, {} as Event);
  }

  close(): void {
    this.isClosed = true;
  }
}

export function createWires(): [Wire, Wire] {
  const [first, second] = [new Wire(), new Wire()];
  [first.other, second.other] = [second, first];
  return [first, second];
}

/** Creates the content of a file, and its entry in a manifest. */
export function makeContent(size: number, fill: number): { readonly data: ArrayBuffer; readonly entry: FileEntry } {
  const data = new Uint8Array(size).fill(fill);
  return { data: data.buffer, entry: { bytes: size, sha256: createHash('sha256').update(data).digest('hex') } };
}

/** Files of the server, by name. */
export type World = Readonly<Record<string, ReturnType<typeof makeContent>>>;

export interface Page {
  readonly number: number;
  readonly share: Share;
  readonly store: LruCache<Blob>;
  /** Budget of bytes that the page sends to all others. */
  readonly budget: Bucket;
  readonly peers: Map<number, Peer>;
  readonly dropped: Map<number, string>;
  /** Users who have sent their lists of files. */
  readonly usersWithFiles: number[];
  /** Names of files requested from the server. */
  readonly serverRequests: string[];
  /** Answers of the server. */
  serve: (name: string) => Promise<ArrayBuffer>;
  shownNames: readonly string[];
  isFirstPictureMissing: boolean;
  get(name: string, signal?: AbortSignal): Promise<ArrayBuffer>;
}

/** Adds a file to the store of a page. */
export function addFile({ store }: Page, key: string, data: ArrayBuffer): void {
  store.add(key, new Blob([data]), data.byteLength);
}

/** Creates a page that is not connected to others yet. */
export function createPage(number: number, world: World, clock: Stepped, ready = Promise.resolve()): Page {
  const [peers, dropped] = [new Map<number, Peer>(), new Map<number, string>()];
  const [store, serverRequests]: [LruCache<Blob>, string[]] = [new LruCache(64 * 2 ** 20), []];
  const open = new Map<string, Promise<ArrayBuffer>>();
  const page: Page = {
    number,
    store,
    budget: createBudget(clock.now),
    peers,
    dropped,
    usersWithFiles: [],
    serverRequests,
    shownNames: Object.keys(world),
    isFirstPictureMissing: false,
    serve: (name) => Promise.resolve(world[name]?.data.slice(0) ?? new ArrayBuffer(0)),
    get(name, signal = new AbortController().signal) {
      const content = open.get(name) ?? page.share.get(name, signal, () => undefined, async (fileName, requestSignal, report) => {
        serverRequests.push(fileName);
        const data = await page.serve(fileName);
        requestSignal.throwIfAborted();
        report(data.byteLength);
        return data;
      });
      open.set(name, content);
      const forget = (): unknown => open.delete(name);
      content.then(forget, forget);
      return content;
    },
    share: createShare({
      store,
      entryOf: (name) => world[name]?.entry,
      shownNames: () => page.shownNames,
      isFirstPictureMissing: () => page.isFirstPictureMissing,
      ownNumber: () => number,
      peers: () => [...peers.values()],
      ready,
      fetch: (name) => page.get(name),
    }),
  };
  let ticks = 0;
  clock.each(() => {
    ticks += 1;
    for (const peer of peers.values()) peer.tick(ticks % 4 === 0);
  });
  return page;
}

/** Connects a page to a user by an end of a channel. */
export function connect(page: Page, number: number, wire: Wire, clock: Clock): Peer {
  const peer = createPeer({
    number,
    channel: wire,
    shelf: page.share.shelf,
    budget: page.budget,
    now: clock.now,
    onSent: () => undefined,
    onFiles: () => page.usersWithFiles.push(number),
    onViolation(sentence) {
      page.dropped.set(number, sentence);
      wire.close();
      peer.end();
      page.peers.delete(number);
    },
  });
  page.peers.set(number, peer);
  page.share.sendFiles(peer);
  return peer;
}

/** Connects two pages; returns both ends of their channel. */
export function join(page: Page, other: Page, clock: Clock): [Wire, Wire] {
  const [pageWire, otherWire] = createWires();
  connect(page, other.number, pageWire, clock);
  connect(other, page.number, otherWire, clock);
  return [pageWire, otherWire];
}
