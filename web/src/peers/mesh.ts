/** Connections to other users: each user connects to the nearest numbers; the user with the smaller number offers. */
import { FrameError } from '../rooms/bytes';
import { type Clock, createBucket } from '../rooms/clock';
import type { FromServer } from '../rooms/frames';
import { type Call, type CallEvents, readSignal, type Signal } from './call';
import { TICK } from './downloads';
import type { Channel } from './peer';

/** Number of neighbours on each side in the circle of user numbers; greatest number of connections. */
const [NEIGHBOURS_PER_SIDE, MAX_CALLS] = [6, 16] as const;
/** Greatest number of answered offers per user. */
const MAX_OFFERS = 8;
/** Rate per second and burst of new connections, to any users. */
const [CALLS_PER_SECOND, CALLS_AT_ONCE] = [1, 16] as const;
/** Timeout for a connection, seconds. */
const CONNECT_TIMEOUT = 10;
/** Ticks that downloads wait for the entry into the room, and then for the connections to others. */
const WAIT_TICKS = Math.round(1.5 / TICK);

export interface MeshSettings {
  readonly clock: Clock;
  readonly create: (events: CallEvents) => Call;
  /** Sends a signal to a user. */
  readonly signal: (user: number, signal: Signal) => void;
  readonly onOpen: (user: number, channel: Channel) => void;
  readonly onEnd: (user: number) => void;
}

/** Connection to a user. */
interface Connection {
  readonly attempt: number;
  readonly call: Call;
  stop: () => void;
  isOpen: boolean;
  /** Whether the user has sent its list of files. */
  hasSentFiles: boolean;
}

export function createMesh({ clock, create, signal, onOpen, onEnd }: MeshSettings) {
  const users = new Set<number>();
  const connections = new Map<number, Connection>();
  const dropped = new Map<number, string>();
  const callRate = createBucket(CALLS_PER_SECOND, CALLS_AT_ONCE, clock.now);
  /** Users with failed connections. */
  const failed = new Set<number>();
  /** Number of offers from each user. */
  const offers = new Map<number, number>();
  /** Offers that arrived before the server has allowed or forbidden connections. */
  const earlyOffers = new Map<number, Signal>();
  let ownNumber: number | null = null;
  /** Whether this page connects; null until the server has answered. */
  let isEnabled: boolean | null = null;
  /** Number of present users whom the server has not announced yet. */
  let unannouncedCount: number | null = null;
  let resolveReady = (): void => undefined;
  const ready = new Promise<void>((done) => (resolveReady = done));
  let [hasEntered, ticks, isOfferScheduled] = [false, WAIT_TICKS, false];

  function countDown(): void {
    ticks -= 1;
    if (ticks <= 0) resolveReady();
    else clock.later(TICK, countDown);
  }
  clock.later(TICK, countDown);

  /** Lets downloads start if all neighbours have sent their lists of files or cannot be connected. */
  function checkReady(): void {
    if (isEnabled === false) resolveReady();
    if (isEnabled === null || unannouncedCount !== 0) return;
    const isExcluded = (user: number): boolean => failed.has(user) || dropped.has(user);
    if (neighbours().every((user) => isExcluded(user) || connections.get(user)?.hasSentFiles)) resolveReady();
  }

  /** Returns the users with the nearest numbers; being neighbours is symmetric. */
  function neighbours(): number[] {
    const others = [...users].sort((a, b) => a - b);
    if (others.length <= 2 * NEIGHBOURS_PER_SIDE) return others;
    const circle = [...others.filter((user) => user > (ownNumber ?? 0)), ...others.filter((user) => user <= (ownNumber ?? 0))];
    return [...circle.slice(0, NEIGHBOURS_PER_SIDE), ...circle.slice(-NEIGHBOURS_PER_SIDE)];
  }

  function fail(user: number): void {
    const connection = connections.get(user);
    if (connection) disconnect(user, connection);
    failed.add(user);
    checkReady();
  }

  function disconnect(user: number, { call, stop, isOpen }: Connection): void {
    connections.delete(user);
    stop();
    call.close();
    if (isOpen) onEnd(user);
  }

  /** Begins a connection; returns null if the browser fails to create one. */
  function connect(user: number, attempt: number): Connection | null {
    const runIfCurrent = (action: () => void): void => {
      if (connections.get(user)?.call === call) action();
    };
    let call: Call;
    try {
      call = create({
        onOpen: (channel) => runIfCurrent(() => {
          connection.stop();
          connection.isOpen = true;
          onOpen(user, channel);
        }),
        onEnd: () => runIfCurrent(() => fail(user)),
        onViolation: (sentence) => runIfCurrent(() => drop(user, sentence)),
      });
    } catch {
      // Browsers allow a few hundred connections per page.
      fail(user);
      return null;
    }
    const stop = clock.later(CONNECT_TIMEOUT, () => fail(user));
    const connection: Connection = { attempt, call, stop, isOpen: false, hasSentFiles: false };
    connections.set(user, connection);
    return connection;
  }

  /** Sends a description when the browser has made it; ends the connection if it fails. */
  function sendDescription(
    user: number,
    connection: Connection,
    kind: 'offer' | 'answer',
    description: Promise<string>,
  ): void {
    const isCurrent = (): boolean => connections.get(user) === connection;
    description
      .then((sdp) => isCurrent() && signal(user, { kind, attempt: connection.attempt, sdp }))
      .catch(() => isCurrent() && fail(user));
  }

  /** Sends offers to neighbours with greater numbers. */
  function sendOffers(): void {
    // Before all users are known, `neighbours` may return users who are not neighbours and would not answer.
    if (!isEnabled || ownNumber === null || unannouncedCount !== 0) return;
    for (const user of neighbours()) {
      const canOffer = user > ownNumber && !connections.has(user) && !failed.has(user) && !dropped.has(user);
      if (!canOffer || connections.size >= MAX_CALLS) continue;
      if (!callRate.take(1)) return scheduleOffers();
      const connection = connect(user, crypto.getRandomValues(new Uint32Array(1))[0] ?? 0);
      if (connection) sendDescription(user, connection, 'offer', connection.call.offer());
    }
  }

  function scheduleOffers(): void {
    if (isOfferScheduled) return;
    isOfferScheduled = true;
    clock.later(callRate.secondsTo(1), () => {
      isOfferScheduled = false;
      sendOffers();
    });
  }

  /** Whether an offer may be answered: only neighbours get this page's addresses and one of its connections. */
  function mayAnswer(user: number): boolean {
    const isPossible = connections.has(user) || connections.size < MAX_CALLS;
    return isEnabled === true && user < (ownNumber ?? 0) && isPossible && neighbours().includes(user);
  }

  function handleSignal(user: number, message: Signal): void {
    const connection = connections.get(user);
    if (message.kind === 'no') {
      if (!connection?.isOpen) fail(user);
    } else if (message.kind === 'answer') {
      if (!connection || connection.isOpen || connection.attempt !== message.attempt || user < (ownNumber ?? 0)) return;
      const reject = (): unknown => connections.get(user) === connection && drop(user, 'its answer is invalid');
      connection.call.accept(message.sdp).catch(reject);
    } else if (isEnabled === null) earlyOffers.set(user, message);
    else if (mayAnswer(user) && callRate.take(1)) answer(user, message, connection);
    else refuse(user);
  }

  function answer(user: number, message: Signal, oldConnection: Connection | undefined): void {
    const count = (offers.get(user) ?? 0) + 1;
    offers.set(user, count);
    if (count > MAX_OFFERS) return drop(user, 'it offers too often');
    if (oldConnection) disconnect(user, oldConnection);
    failed.delete(user);
    const connection = connect(user, message.attempt);
    if (connection) sendDescription(user, connection, 'answer', connection.call.answer(message.sdp));
  }

  function refuse(user: number): void {
    signal(user, { kind: 'no', attempt: 0, sdp: '' });
  }

  function hearSignal(user: number, payload: Uint8Array): void {
    if (!users.has(user) || dropped.has(user)) return;
    try {
      handleSignal(user, readSignal(payload));
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
    const connection = connections.get(user);
    if (connection) disconnect(user, connection);
  }

  function forget(): void {
    for (const user of [...users]) leave(user);
    ownNumber = unannouncedCount = null;
  }

  /** Disconnects a user who has violated the protocol. */
  function drop(user: number, sentence: string): void {
    dropped.set(user, dropped.get(user) ?? sentence);
    fail(user);
  }

  return {
    /**
     * Resolves when all initial neighbours have sent their lists of files or cannot be connected, or after a timeout.
     */
    ready,
    /** Users who have violated the protocol and are not connected again, with their violations. */
    dropped,
    /** User's own number; null outside the room. */
    get ownNumber(): number | null {
      return ownNumber;
    },
    drop,
    /** Records that a user has sent its list of files. */
    recordFiles(user: number): void {
      const connection = connections.get(user);
      if (connection) connection.hasSentFiles = true;
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
        unannouncedCount = frame.others;
      } else if (frame.kind === 'joined') {
        // A returning user has a new page.
        leave(frame.user);
        users.add(frame.user);
        if (unannouncedCount) unannouncedCount -= 1;
        if (isEnabled === false) refuse(frame.user);
      } else if (frame.kind === 'left') leave(frame.user);
      else if (frame.kind === 'signal') hearSignal(frame.user, frame.payload);
      else return;
      sendOffers();
      checkReady();
    },
    /** Begins to connect, or ends all connections and tells the other users that this page does not connect. */
    setEnabled(isOn: boolean): void {
      isEnabled = isOn;
      if (!isOn) {
        for (const [user, connection] of [...connections]) disconnect(user, connection);
        for (const user of users) refuse(user);
      }
      sendOffers();
      if (isOn) for (const [user, message] of earlyOffers) handleSignal(user, message);
      earlyOffers.clear();
      checkReady();
    },
  };
}
