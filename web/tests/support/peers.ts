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

/** A clock whose ticks call actions and await pending work. */
export function steppedClock() {
  const { advance, ...clock } = createSteppedClock();
  const actions: (() => void)[] = [];
  return {
    ...clock,
    /** Calls a function at each tick. */
    each: (action: () => void): void => void actions.push(action),
    /** Lets some seconds pass, in ticks. */
    async pass(seconds: number): Promise<void> {
      for (let remaining = seconds; remaining > 1e-9; remaining -= TICK) {
        advance(Math.min(TICK, remaining));
        for (const action of actions) action();
        await settled();
      }
    },
  };
}

/** Hashes being computed now by worker threads in real time. */
let hashes = 0;
const digest = crypto.subtle.digest.bind(crypto.subtle);
crypto.subtle.digest = async (...given) => {
  hashes += 1;
  try {
    return await digest(...given);
  } finally {
    hashes -= 1;
  }
};

/** Waits until no hash is being computed, and then for a number of event loop turns. */
export async function settled(turns = 60): Promise<void> {
  for (let turn = 0; turn < turns; turn = hashes > 0 ? 0 : turn + 1) await new Promise((done) => setImmediate(done));
}

/** One end of a channel. Sent data reaches the other end in order, later. */
export class Wire implements Channel {
  binaryType: BinaryType = 'blob';
  bufferedAmount = 0;
  bufferedAmountLowThreshold = 0;
  onmessage: Channel['onmessage'] = null;
  onbufferedamountlow: Channel['onbufferedamountlow'] = null;
  other: Wire | null = null;
  isClosed = false;
  /** Stop delivery of sent data. */
  isHeld = false;
  readonly sent: Uint8Array[] = [];

  send(data: unknown): void {
    if (this.isClosed) throw new Error('the channel is closed');
    const bytes = (data as Uint8Array).slice();
    this.sent.push(bytes);
    if (this.isHeld) this.bufferedAmount += bytes.length;
    else setImmediate(() => this.other?.comes(bytes.buffer));
  }

  comes(data: unknown): void {
    if (!this.isClosed) this.onmessage?.call(this as unknown as RTCDataChannel, { data } as MessageEvent);
  }

  /** Deliver all held data. */
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

/** Content of some size, and how a manifest lists it. */
export function makeContent(size: number, fill: number): { readonly data: ArrayBuffer; readonly listed: FileEntry } {
  const data = new Uint8Array(size).fill(fill);
  return { data: data.buffer, listed: { bytes: size, sha256: createHash('sha256').update(data).digest('hex') } };
}

export type World = Readonly<Record<string, ReturnType<typeof makeContent>>>;

export interface Page {
  readonly number: number;
  readonly share: Share;
  readonly store: LruCache<Blob>;
  /** Bytes that it gives to all others. */
  readonly budget: Bucket;
  readonly peers: Map<number, Peer>;
  readonly dropped: Map<number, string>;
  /** Users who have announced their files. */
  readonly greeted: number[];
  /** Names of files requested from the server. */
  readonly serverRequests: string[];
  /** Answers of the server. */
  serve: (name: string) => Promise<ArrayBuffer>;
  shownNames: readonly string[];
  isFirst: boolean;
  get(name: string, signal?: AbortSignal): Promise<ArrayBuffer>;
}

/** Lets a page have a content. */
export function hold({ store }: Page, key: string, data: ArrayBuffer): void {
  store.add(key, new Blob([data]), data.byteLength);
}

/** A page of a world; whoever it is joined with comes later. */
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
    greeted: [],
    serverRequests,
    shownNames: Object.keys(world),
    isFirst: false,
    serve: (name) => Promise.resolve(world[name]?.data.slice(0) ?? new ArrayBuffer(0)),
    get(name, signal = new AbortController().signal) {
      const asking = open.get(name) ?? page.share.get(name, signal, () => undefined, async (fileName, requestSignal, report) => {
        serverRequests.push(fileName);
        const data = await page.serve(fileName);
        requestSignal.throwIfAborted();
        report(data.byteLength);
        return data;
      });
      open.set(name, asking);
      const forget = (): unknown => open.delete(name);
      asking.then(forget, forget);
      return asking;
    },
    share: createShare({
      store,
      entryOf: (name) => world[name]?.listed,
      shownNames: () => page.shownNames,
      isFirstPictureMissing: () => page.isFirst,
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

/** Gives a page an end of a channel to a user. */
export function plug(page: Page, number: number, line: Wire, clock: Clock): Peer {
  const peer = createPeer({
    number,
    channel: line,
    shelf: page.share.shelf,
    budget: page.budget,
    now: clock.now,
    sent: () => undefined,
    greeted: () => page.greeted.push(number),
    refuse(sentence) {
      page.dropped.set(number, sentence);
      line.close();
      peer.end();
      page.peers.delete(number);
    },
  });
  page.peers.set(number, peer);
  page.share.greet(peer);
  return peer;
}

/** Joins two pages; returns both ends of their channel. */
export function join(page: Page, other: Page, clock: Clock): [Wire, Wire] {
  const [pageWire, otherWire] = createWires();
  plug(page, other.number, pageWire, clock);
  plug(other, page.number, otherWire, clock);
  return [pageWire, otherWire];
}
