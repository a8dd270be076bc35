/** Exchange of files between pages of a room; the server relays signals and sends files that no page has. */
import { LruCache } from '../base/cache';
import type { Files } from '../bundle/source';
import { CLOCK } from '../rooms/clock';
import type { Ask } from '../rooms/server';
import { createCall, createOutbox, writeSignal } from './call';
import { createChoice, refusalOfPage, refusalOfServer, SWITCHED_OFF } from './choice';
import { TICK } from './downloads';
import { createMesh } from './mesh';
import { createPeer, type Peer } from './peer';
import { createShare, type ShareSettings } from './share';
import { createBudget } from './uploads';

/** Greatest size of the files that this page stores for others, bytes. */
const MAX_STORED_BYTES = 64 * 2 ** 20;
const TICKS_PER_SECOND = Math.round(1 / TICK);

export interface PeersSettings extends Pick<ShareSettings, 'shownNames' | 'isFirstPictureMissing'> {
  readonly query: URLSearchParams;
  /** Requests the server's settings of rooms. */
  readonly ask: Ask;
  readonly files: Files;
  /** Sends a signal to a user of the room. */
  readonly signal: (user: number, payload: Uint8Array) => void;
}

export function startPeers({ query, ask, files, shownNames, isFirstPictureMissing, signal }: PeersSettings) {
  const peers = new Map<number, Peer>();
  const store = new LruCache<Blob>(MAX_STORED_BYTES);
  const outbox = createOutbox(signal, CLOCK);
  const budget = createBudget(CLOCK.now);
  const choice = createChoice();
  let refusal: string | null | undefined;
  let sentBytes = 0;

  const mesh = createMesh({
    clock: CLOCK,
    create: (events) => createCall(events, CLOCK.later),
    signal: (user, message) => outbox.send(user, writeSignal(message)),
    onOpen(number, channel) {
      const peer = createPeer({
        number,
        channel,
        shelf: share.shelf,
        budget,
        now: CLOCK.now,
        onSent: (bytes) => (sentBytes += bytes),
        onFiles: () => mesh.recordFiles(number),
        onViolation: (sentence) => mesh.drop(number, sentence),
      });
      peers.set(number, peer);
      share.sendFiles(peer);
    },
    onEnd(number) {
      peers.get(number)?.end();
      peers.delete(number);
    },
  });
  const share = createShare({
    store,
    entryOf: files.entryOf,
    shownNames,
    isFirstPictureMissing,
    ownNumber: () => mesh.ownNumber,
    peers: () => [...peers.values()],
    ready: mesh.ready,
    fetch: files.fetch,
  });

  let ticks = 0;
  function tick(): void {
    ticks += 1;
    if (refusal !== null) return;
    for (const peer of peers.values()) peer.tick(ticks % TICKS_PER_SECOND === 0);
    CLOCK.later(TICK, tick);
  }

  /** Begins the exchange, or ends it if there is a reason. */
  function decide(reason: string | null): void {
    refusal = reason;
    mesh.setEnabled(reason === null);
    if (reason === null) tick();
    else files.setRoute(null);
  }

  /** Switch by which the user allows the exchange. */
  const ownSwitch = {
    get isOn(): boolean {
      return choice.isOn;
    },
    /** Stores the choice. Switching off ends the exchange at once; switching on takes effect after a reload. */
    set(isOn: boolean): void {
      choice.set(isOn);
      if (!isOn && refusal === null) decide(SWITCHED_OFF);
    },
  };

  const pageRefusal = refusalOfPage(query, choice);
  if (pageRefusal === null) {
    files.setRoute(share.get);
    void ask().then((description) => decide(refusalOfServer(description)));
  } else decide(pageRefusal);

  return {
    /** Users who have violated the protocol, with their violations. */
    dropped: mesh.dropped,
    /** Reason why this page does not take part in the exchange; null if it does, undefined until the server answers. */
    get refusal(): string | null | undefined {
      return refusal;
    },
    /** Numbers of the users with open channels. */
    get open(): readonly number[] {
      return [...peers.keys()];
    },
    /** Bytes and files received from other pages and from the server; bytes sent to other pages. */
    get counts() {
      return { ...share.counts, sent: sentBytes };
    },
    /** The user's switch; null if the exchange is impossible anyway. */
    get switch(): typeof ownSwitch | null {
      return refusal === null || refusal === SWITCHED_OFF ? ownSwitch : null;
    },
    hear: mesh.hear,
    /** Ends all connections, because the user has left the room. */
    clear(): void {
      outbox.clear();
      mesh.clear();
    },
  };
}
