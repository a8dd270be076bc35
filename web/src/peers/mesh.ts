/** Connections between users: each connects to its nearest neighbours; of two users, the one with the smaller number sends the offer. */
import { FrameError } from '../rooms/bytes';
import { type Clock, createBucket } from '../rooms/clock';
import type { FromServer } from '../rooms/frames';
import { type Call, type CallEvents, readSignal, type Signal } from './call';
import { TICK } from './downloads';
import type { Channel } from './peer';

/** Neighbours on each side in the circle of numbers; greatest number of connections. */
const [NEIGHBOURS_PER_SIDE, MAX_CALLS] = [6, 16] as const;
/** Greatest number of answered offers per user. */
const MAX_OFFERS = 8;
/** Rate per second and burst of new connections, to any users. */
const [CALLS_PER_SECOND, CALLS_AT_ONCE] = [1, 16] as const;
/** Timeout for a connection, seconds. */
const CONNECT_TIMEOUT = 10;
/** Ticks before downloads start without having entered the room, and again before they start without all connections. */
const WAIT_TICKS = Math.round(1.5 / TICK);

export interface MeshSettings {
  readonly clock: Clock;
  readonly create: (events: CallEvents) => Call;
  /** Sends a signal to a user. */
  readonly signal: (user: number, signal: Signal) => void;
  readonly opened: (user: number, channel: Channel) => void;
  readonly ended: (user: number) => void;
}

interface Slot {
  readonly attempt: number;
  readonly call: Call;
  stop: () => void;
  isOpen: boolean;
  hasGreeted: boolean;
}

export function createMesh({ clock, create, signal, opened, ended }: MeshSettings) {
  const users = new Set<number>();
  const slots = new Map<number, Slot>();
  const dropped = new Map<number, string>();
  const calls = createBucket(CALLS_PER_SECOND, CALLS_AT_ONCE, clock.now);
  /** Users with failed connections. */
  const failed = new Set<number>();
  /** Number of offers from each user. */
  const offers = new Map<number, number>();
  /** Offers that arrived before it was known whether this page connects. */
  const earlyOffers = new Map<number, Signal>();
  let ownNumber: number | null = null;
  let isOn: boolean | null = null;
  /** Number of present users that the server has not announced yet. */
  let unannounced: number | null = null;
  let resolveReady = (): void => undefined;
  const ready = new Promise<void>((done) => (resolveReady = done));
  let [hasEntered, ticks, isOfferScheduled] = [false, WAIT_TICKS, false];

  function wait(): void {
    ticks -= 1;
    if (ticks <= 0) resolveReady();
    else clock.later(TICK, wait);
  }
  clock.later(TICK, wait);

  /** Lets downloads start if no neighbour is left to connect to. */
  function checkReady(): void {
    if (isOn === false) resolveReady();
    if (isOn === null || unannounced !== 0) return;
    const isExcluded = (user: number): boolean => failed.has(user) || dropped.has(user);
    if (neighbours().every((user) => isExcluded(user) || slots.get(user)?.hasGreeted)) resolveReady();
  }

  /** Returns the nearest users by number; the relation is symmetric. */
  function neighbours(): number[] {
    const others = [...users].sort((a, b) => a - b);
    if (others.length <= 2 * NEIGHBOURS_PER_SIDE) return others;
    const circle = [...others.filter((user) => user > (ownNumber ?? 0)), ...others.filter((user) => user <= (ownNumber ?? 0))];
    return [...circle.slice(0, NEIGHBOURS_PER_SIDE), ...circle.slice(-NEIGHBOURS_PER_SIDE)];
  }

  function fail(user: number): void {
    const slot = slots.get(user);
    if (slot) remove(user, slot);
    failed.add(user);
    checkReady();
  }

  function remove(user: number, { call, stop, isOpen }: Slot): void {
    slots.delete(user);
    stop();
    call.close();
    if (isOpen) ended(user);
  }

  /** Begins a connection; null if the browser creates none. */
  function open(user: number, attempt: number): Slot | null {
    const ifCurrent = (action: () => void): void => {
      if (slots.get(user)?.call === call) action();
    };
    let call: Call;
    try {
      call = create({
        opened: (channel) => ifCurrent(() => {
          slot.stop();
          slot.isOpen = true;
          opened(user, channel);
        }),
        ended: () => ifCurrent(() => fail(user)),
        refuse: (sentence) => ifCurrent(() => drop(user, sentence)),
      });
    } catch {
      // Browsers allow a few hundred connections per page.
      fail(user);
      return null;
    }
    const stop = clock.later(CONNECT_TIMEOUT, () => fail(user));
    const slot: Slot = { attempt, call, stop, isOpen: false, hasGreeted: false };
    slots.set(user, slot);
    return slot;
  }

  /** Sends a description when it is available; failure ends the connection. */
  function describe(user: number, slot: Slot, kind: 'offer' | 'answer', description: Promise<string>): void {
    const isCurrent = (): boolean => slots.get(user) === slot;
    description
      .then((sdp) => isCurrent() && signal(user, { kind, attempt: slot.attempt, sdp }))
      .catch(() => isCurrent() && fail(user));
  }

  /** Sends offers to neighbours with greater numbers. */
  function offer(): void {
    // Until all users are known, `neighbours` may return users who turn out not to be neighbours, and would not answer.
    if (!isOn || ownNumber === null || unannounced !== 0) return;
    for (const user of neighbours()) {
      const canOffer = user > ownNumber && !slots.has(user) && !failed.has(user) && !dropped.has(user);
      if (!canOffer || slots.size >= MAX_CALLS) continue;
      if (!calls.take(1)) return offerLater();
      const slot = open(user, crypto.getRandomValues(new Uint32Array(1))[0] ?? 0);
      if (slot) describe(user, slot, 'offer', slot.call.offer());
    }
  }

  function offerLater(): void {
    if (isOfferScheduled) return;
    isOfferScheduled = true;
    clock.later(calls.secondsTo(1), () => {
      isOfferScheduled = false;
      offer();
    });
  }

  /** Whether an offer is answered: only neighbours get this page's addresses and one of its connections. */
  function isAnswered(user: number): boolean {
    const hasSlot = slots.has(user) || slots.size < MAX_CALLS;
    return isOn === true && user < (ownNumber ?? 0) && hasSlot && neighbours().includes(user);
  }

  function takeSignal(user: number, message: Signal): void {
    const slot = slots.get(user);
    if (message.kind === 'no') {
      if (!slot?.isOpen) fail(user);
    } else if (message.kind === 'answer') {
      if (!slot || slot.isOpen || slot.attempt !== message.attempt || user < (ownNumber ?? 0)) return;
      slot.call.take(message.sdp).catch(() => slots.get(user) === slot && drop(user, 'its answer is invalid'));
    } else if (isOn === null) earlyOffers.set(user, message);
    else if (isAnswered(user) && calls.take(1)) answer(user, message, slot);
    else refuse(user);
  }

  function answer(user: number, message: Signal, oldSlot: Slot | undefined): void {
    const count = (offers.get(user) ?? 0) + 1;
    offers.set(user, count);
    if (count > MAX_OFFERS) return drop(user, 'it offers too often');
    if (oldSlot) remove(user, oldSlot);
    failed.delete(user);
    const slot = open(user, message.attempt);
    if (slot) describe(user, slot, 'answer', slot.call.answer(message.sdp));
  }

  function refuse(user: number): void {
    signal(user, { kind: 'no', attempt: 0, sdp: '' });
  }

  function hearSignal(user: number, payload: Uint8Array): void {
    if (!users.has(user) || dropped.has(user)) return;
    try {
      takeSignal(user, readSignal(payload));
    } catch (error) {
      if (!(error instanceof FrameError)) throw error;
      // Other programs in the room may use their own signals.
      fail(user);
    }
  }

  function leave(user: number): void {
    users.delete(user);
    failed.delete(user);
    offers.delete(user);
    earlyOffers.delete(user);
    const slot = slots.get(user);
    if (slot) remove(user, slot);
  }

  function forget(): void {
    for (const user of [...users]) leave(user);
    ownNumber = unannounced = null;
  }

  /** Disconnects a user who has violated the protocol. */
  function drop(user: number, sentence: string): void {
    dropped.set(user, dropped.get(user) ?? sentence);
    fail(user);
  }

  return {
    /** Resolves when all users present at first have sent their lists of files or do not connect, or after a timeout. */
    ready,
    /** Users who have violated the protocol, with the violation: no more connections to them. */
    dropped,
    /** User's own number; null outside the room. */
    get ownNumber(): number | null {
      return ownNumber;
    },
    drop,
    /** Records that a user has sent its list of files, which ends waiting for it. */
    greeted(user: number): void {
      const slot = slots.get(user);
      if (slot) slot.hasGreeted = true;
      checkReady();
    },
    /** Forgets all users, because the user has left the room. */
    clear(): void {
      forget();
      resolveReady();
    },
    hear(frame: FromServer): void {
      if (frame.kind === 'welcome') {
        forget();
        ownNumber = frame.user;
        if (!hasEntered) [hasEntered, ticks] = [true, WAIT_TICKS];
        unannounced = frame.others;
      } else if (frame.kind === 'joined') {
        // A returning user has a new page.
        leave(frame.user);
        users.add(frame.user);
        if (unannounced) unannounced -= 1;
        if (isOn === false) refuse(frame.user);
      } else if (frame.kind === 'left') leave(frame.user);
      else if (frame.kind === 'signal') hearSignal(frame.user, frame.payload);
      else return;
      offer();
      checkReady();
    },
    /** Begins to connect; or ends all connections and tells all others that this page does not connect. */
    begin(isEnabled: boolean): void {
      isOn = isEnabled;
      if (!isEnabled) {
        for (const [user, slot] of [...slots]) remove(user, slot);
        for (const user of users) refuse(user);
      }
      offer();
      if (isEnabled) for (const [user, message] of earlyOffers) takeSignal(user, message);
      earlyOffers.clear();
      checkReady();
    },
  };
}
