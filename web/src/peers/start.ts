/** Exchange of files between pages of a room; the server relays signals and sends files that no page has. */
import { LruCache } from '../base/cache';
import type { FileEntry } from '../bundle/manifest';
import type { Files } from '../bundle/source';
import { CLOCK } from '../rooms/clock';
import type { FromServer } from '../rooms/frames';
import type { Ask } from '../rooms/server';
import { createCall, createOutbox, writeSignal } from './call';
import { createChoice, refusalHere, refusalThere, UNWANTED } from './choice';
import { TICK } from './downloads';
import { createMesh } from './mesh';
import { createPeer, type Peer } from './peer';
import { type Counts, createShare } from './share';
import { createBudget } from './uploads';

/** Greatest number of bytes of contents for others. */
const MAX_STORED_BYTES = 64 * 2 ** 20;
/** Ticks per second. */
const SECOND = Math.round(1 / TICK);

export interface PeersSettings {
  /** Query of the page's address. */
  readonly query: URLSearchParams;
  /** Asks the server for its settings of rooms. */
  readonly ask: Ask;
  readonly files: Files;
  readonly wanted: () => Iterable<string>;
  readonly isFirst: () => boolean;
  /** Sends a signal to a user of the room. */
  readonly signal: (user: number, payload: Uint8Array) => void;
}

/** User's switch, available if nothing else prevents the exchange. */
export interface Switch {
  readonly isOn: boolean;
  /** Sets the choice: off ends the exchange; on begins it when the page is reloaded. */
  set(isOn: boolean): void;
}

export interface Peers {
  /** Why this page does not take part; null if it does, undefined until that is known. */
  readonly refusal: string | null | undefined;
  /** Numbers of the users with open channels. */
  readonly open: readonly number[];
  /** Users who have violated the protocol, with the violation. */
  readonly dropped: ReadonlyMap<number, string>;
  /** Bytes and files received from other pages and from the server; bytes sent to other pages. */
  readonly counts: Counts & { readonly sent: number };
  /** User's switch; null if there is no choice. */
  readonly switch: Switch | null;
  hear(frame: FromServer): void;
  /** Ends all connections, because the user has left the room. */
  clear(): void;
}

/** Starts the exchange of files if all sides allow it. */
export function startPeers({ query, ask, files, wanted, isFirst, signal }: PeersSettings): Peers {
  const clock = CLOCK;
  const peers = new Map<number, Peer>();
  const store = new LruCache<Blob>(MAX_STORED_BYTES);
  const outbox = createOutbox(signal, clock);
  const budget = createBudget(clock.now);
  const choice = createChoice();
  let refusal: string | null | undefined;
  let sent = 0;

  const mesh = createMesh({
    clock,
    create: (events) => createCall(events, clock.later),
    signal: (user, message) => outbox.send(user, writeSignal(message)),
    opened(number, line) {
      const peer = createPeer({
        number,
        line,
        shelf: share.shelf,
        budget,
        now: clock.now,
        sent: (bytes) => (sent += bytes),
        greeted: () => mesh.greeted(number),
        refuse: (sentence) => mesh.drop(number, sentence),
      });
      peers.set(number, peer);
      share.greet(peer);
    },
    ended(number) {
      peers.get(number)?.end();
      peers.delete(number);
    },
  });
  const share = createShare({
    store,
    described: (name): FileEntry | undefined => files.described(name),
    wanted,
    isFirst,
    own: () => mesh.own,
    peers: () => [...peers.values()],
    ready: mesh.ready,
    fetch: files.fetch,
  });

  let ticks = 0;
  function tick(): void {
    ticks += 1;
    if (refusal !== null) return;
    for (const peer of peers.values()) peer.tick(ticks % SECOND === 0);
    clock.later(TICK, tick);
  }

  function begin(reason: string | null): void {
    refusal = reason;
    mesh.begin(reason === null);
    if (reason === null) tick();
    else files.setRoute(null);
  }

  const ownSwitch: Switch = {
    get isOn() {
      return choice.isOn;
    },
    set(isOn) {
      choice.set(isOn);
      if (!isOn && refusal === null) begin(UNWANTED);
    },
  };

  const here = refusalHere(query, choice);
  if (here === null) {
    files.setRoute(share.get);
    void ask().then((about) => begin(refusalThere(about)));
  } else {
    begin(here);
  }

  return {
    dropped: mesh.dropped,
    get refusal() {
      return refusal;
    },
    get open() {
      return [...peers.keys()];
    },
    get counts() {
      return { ...share.counts, sent };
    },
    get switch() {
      return refusal === null || refusal === UNWANTED ? ownSwitch : null;
    },
    hear: mesh.hear,
    clear() {
      outbox.clear();
      mesh.clear();
    },
  };
}
