/** Who connects to whom: of two users the one with the smaller number offers, and each connects to some of them. */
import { FrameError } from '../rooms/bytes';
import type { Clock } from '../rooms/clock';
import type { FromServer } from '../rooms/frames';
import { createBucket } from './bucket';
import type { Call, CallEvents } from './call';
import { TICK } from './downloads';
import type { Line } from './peer';
import { readSignal, type Signal } from './signals';

/** Users before and after one's own number, in a circle, to whom a page connects; and connections at the same time. */
const [REACH, MOST_CALLS] = [6, 16] as const;
/** Offers of a user that are answered. */
const MOST_OFFERS = 8;
/** Connections that are made a second, and at once, whoever they are to. */
const [RATE, BURST] = [1, 16] as const;
/** Seconds in which a connection must come about. */
const CONNECT = 10;
/** Ticks for which files wait at first: to enter the room, and then for all connections. */
const FIRST = Math.round(1.5 / TICK);

export interface MeshSettings {
  readonly clock: Clock;
  readonly create: (events: CallEvents) => Call;
  /** Send a signal to a user. */
  readonly signal: (user: number, signal: Signal) => void;
  readonly opened: (user: number, line: Line) => void;
  readonly ended: (user: number) => void;
}

export interface Mesh {
  /** The user's own number; null outside of the room. */
  readonly own: number | null;
  /** Users who have broken the rules, and how: they are not connected to any more. */
  readonly dropped: ReadonlyMap<number, string>;
  hear(frame: FromServer): void;
  /** The user is not in the room. */
  clear(): void;
  /** Connect from now on; or end all connections, and tell all others that this page does not connect. */
  begin(isOn: boolean): void;
  /** A user has told what its page has: nobody waits for it any more. */
  greeted(user: number): void;
  /** A user has broken the rules. */
  drop(user: number, sentence: string): void;
  /** Resolves when all who were there at first have told what they have or do not connect, or some time has passed. */
  readonly ready: Promise<void>;
}

interface Place {
  readonly attempt: number;
  readonly call: Call;
  stop: () => void;
  isOpen: boolean;
  hasGreeted: boolean;
}

export function createMesh({ clock, create, signal, opened, ended }: MeshSettings): Mesh {
  const users = new Set<number>();
  const places = new Map<number, Place>();
  const dropped = new Map<number, string>();
  const calls = createBucket(RATE, BURST, clock.now);
  /** Users with whom no connection has come about. */
  const failed = new Set<number>();
  /** Offers that have come from each user. */
  const offers = new Map<number, number>();
  /** Offers that came before it was known whether this page connects. */
  const early = new Map<number, Signal>();
  let own: number | null = null;
  let isOn: boolean | null = null;
  /** Users who were there before, and of whom the server has not told yet. */
  let untold: number | null = null;
  let settle = (): void => undefined;
  const ready = new Promise<void>((done) => (settle = done));
  let [hasEntered, ticks, isLate] = [false, FIRST, false];

  function wait(): void {
    ticks -= 1;
    if (ticks <= 0) settle();
    else clock.later(TICK, wait);
  }
  clock.later(TICK, wait);

  /** Whether nobody is left of whom files wait. */
  function look(): void {
    if (isOn === false) settle();
    if (isOn === null || own === null || untold === null || untold > 0) return;
    const isOver = (user: number): boolean => failed.has(user) || dropped.has(user);
    if (neighbours().every((user) => isOver(user) || places.get(user)?.hasGreeted)) settle();
  }

  /** The nearest users by their numbers; of two users each is the other's neighbour, or none is. */
  function neighbours(): number[] {
    const others = [...users].sort((a, b) => a - b);
    if (others.length <= 2 * REACH) return others;
    const after = others.findIndex((user) => user > (own ?? 0));
    const begin = after < 0 ? others.length : after;
    const circle = [...others.slice(begin), ...others.slice(0, begin)];
    return [...circle.slice(0, REACH), ...circle.slice(-REACH)];
  }

  function fail(user: number): void {
    const place = places.get(user);
    if (place) remove(user, place);
    failed.add(user);
    look();
  }

  function remove(user: number, { call, stop, isOpen }: Place): void {
    places.delete(user);
    stop();
    call.close();
    if (isOpen) ended(user);
  }

  /** Begin a connection; null if the browser makes none. */
  function open(user: number, attempt: number): Place | null {
    try {
      return begun(user, attempt);
    } catch {
      // Browsers allow some hundreds for each page.
      fail(user);
      return null;
    }
  }

  function begun(user: number, attempt: number): Place {
    const isCurrent = (): boolean => places.get(user) === place;
    const call = create({
      opened(line) {
        if (!isCurrent()) return;
        place.stop();
        place.isOpen = true;
        opened(user, line);
      },
      ended() {
        if (isCurrent()) fail(user);
      },
      refuse(sentence) {
        if (isCurrent()) drop(user, sentence);
      },
    });
    const stop = clock.later(CONNECT, () => fail(user));
    const place: Place = { attempt, call, stop, isOpen: false, hasGreeted: false };
    places.set(user, place);
    return place;
  }

  /** Send a description when it is there; without one there is no connection. */
  function describe(user: number, place: Place, kind: 'offer' | 'answer', description: Promise<string>): void {
    const isCurrent = (): boolean => places.get(user) === place;
    description
      .then((sdp) => isCurrent() && signal(user, { kind, attempt: place.attempt, sdp }))
      .catch(() => isCurrent() && fail(user));
  }

  /** Offer to those who are to be offered to. */
  function offer(): void {
    // Before all are known, others may be neighbours than later, who would not answer.
    if (!isOn || own === null || untold === null || untold > 0) return;
    for (const user of neighbours()) {
      const isOther = user > own && !places.has(user) && !failed.has(user) && !dropped.has(user);
      if (!isOther || places.size >= MOST_CALLS) continue;
      if (!calls.take(1)) {
        offerLater();
        return;
      }
      const place = open(user, crypto.getRandomValues(new Uint32Array(1))[0] ?? 0);
      if (place) describe(user, place, 'offer', place.call.offer());
    }
  }

  function offerLater(): void {
    if (isLate) return;
    isLate = true;
    clock.later(calls.secondsTo(1), () => {
      isLate = false;
      offer();
    });
  }

  /** Whether an offer is answered: users who are no neighbours get neither this page's address nor its places. */
  function isAnswered(user: number): boolean {
    const hasPlace = places.has(user) || places.size < MOST_CALLS;
    return isOn === true && user < (own ?? 0) && hasPlace && neighbours().includes(user);
  }

  function takeSignal(user: number, said: Signal): void {
    const place = places.get(user);
    if (said.kind === 'no') {
      if (!place?.isOpen) fail(user);
    } else if (said.kind === 'answer') {
      if (!place || place.isOpen || place.attempt !== said.attempt || user < (own ?? 0)) return;
      place.call.take(said.sdp).catch(() => places.get(user) === place && drop(user, 'its answer is none'));
    } else if (isOn === null) {
      early.set(user, said);
    } else if (isAnswered(user) && calls.take(1)) {
      answer(user, said, place);
    } else {
      refuse(user);
    }
  }

  function answer(user: number, said: Signal, before: Place | undefined): void {
    const count = (offers.get(user) ?? 0) + 1;
    offers.set(user, count);
    if (count > MOST_OFFERS) {
      drop(user, 'it offers too often');
      return;
    }
    if (before) remove(user, before);
    failed.delete(user);
    const place = open(user, said.attempt);
    if (place) describe(user, place, 'answer', place.call.answer(said.sdp));
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
      // Other programs of the room may have signals of their own.
      fail(user);
    }
  }

  function leave(user: number): void {
    users.delete(user);
    failed.delete(user);
    offers.delete(user);
    early.delete(user);
    const place = places.get(user);
    if (place) remove(user, place);
  }

  function forget(): void {
    for (const user of [...users]) leave(user);
    own = untold = null;
  }

  function drop(user: number, sentence: string): void {
    dropped.set(user, dropped.get(user) ?? sentence);
    fail(user);
  }

  return {
    ready,
    dropped,
    get own() {
      return own;
    },
    drop,
    greeted(user) {
      const place = places.get(user);
      if (place) place.hasGreeted = true;
      look();
    },
    clear() {
      forget();
      settle();
    },
    hear(frame) {
      if (frame.kind === 'welcome') {
        forget();
        own = frame.user;
        if (!hasEntered) [hasEntered, ticks] = [true, FIRST];
        untold = frame.others;
      } else if (frame.kind === 'joined') {
        // Who comes back has another page.
        leave(frame.user);
        users.add(frame.user);
        if (untold !== null && untold > 0) untold -= 1;
        if (isOn === false) refuse(frame.user);
      } else if (frame.kind === 'left') {
        leave(frame.user);
      } else if (frame.kind === 'signal') {
        hearSignal(frame.user, frame.payload);
      } else {
        return;
      }
      offer();
      look();
    },
    begin(on) {
      isOn = on;
      if (!on) {
        for (const [user, place] of [...places]) remove(user, place);
        for (const user of users) refuse(user);
      }
      offer();
      if (on) for (const [user, said] of early) takeSignal(user, said);
      early.clear();
      look();
    },
  };
}
