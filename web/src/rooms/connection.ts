/** Connection to a room: joins, reconnects, acknowledges poses and measures round trips. */
import { type Address, relayOf } from './address';
import { FrameError } from './bytes';
import { CLOCK, type Clock } from './clock';
import { type Audience, type FromServer, type FromUser, readMessage, writeFrame } from './frames';
import type { Body } from './pose';
import { CLOSE_TIMEOUT, type End, endOf, endOfCode, type Open, openSocket, type Socket } from './server';

/** Least and greatest delay before a reconnection, seconds. */
const [MIN_DELAY, MAX_DELAY] = [1, 30] as const;
/** Seconds in the room after which the delay is reset; timeout in seconds for the welcome. */
const [STABLE_SECONDS, WELCOME_TIMEOUT] = [10, 15] as const;
/** Number of buffered bytes above which poses are dropped. */
const MAX_BUFFERED_BYTES = 1 << 14;

export type State =
  | { readonly kind: 'joining' }
  | { readonly kind: 'here'; readonly user: number }
  /** Waits for some seconds before it reconnects. */
  | { readonly kind: 'waiting'; readonly words: string; readonly seconds: number }
  | { readonly kind: 'ended'; readonly words: string };

export interface ConnectionSettings {
  readonly address: Address;
  /** Address of the page, relative to which the room is found. */
  readonly page: string;
  /** Ticket from an earlier connection; empty by default. */
  readonly ticket?: Uint8Array;
  /** Called with a frame of the server and its time of arrival; `welcome` resets all known users. */
  readonly onFrame: (frame: FromServer, now: number) => void;
  readonly onChange: (state: State) => void;
  /** Opens a socket; a WebSocket by default. */
  readonly open?: Open;
  readonly clock?: Clock;
}

export type Connection = ReturnType<typeof connect>;

export function connect(settings: ConnectionSettings) {
  const { address, page, onFrame, onChange, open = openSocket, clock = CLOCK } = settings;
  const { now, later } = clock;
  const roundTrips = createRoundTrips();
  let state: State = { kind: 'joining' };
  let socket: Socket | null = null;
  /** Previous socket, until the server has closed it. */
  let closingSocket: Socket | null = null;
  let ticket = settings.ticket ?? new Uint8Array();
  let delay: number = MIN_DELAY;
  let [connectedAt, sequence] = [0, 0];
  let cancelTimer = (): void => undefined;
  /** Other users who receive this user's poses. */
  const groupMembers = new Set<number>();
  /** Greatest sequence number received from each present user. */
  const newestSequences = new Map<number, number>();

  function setState(next: State): void {
    state = next;
    onChange(next);
  }

  function join(): void {
    cancelTimer();
    setState({ kind: 'joining' });
    // Otherwise the hello could overtake the bye, while the user's token is still in use.
    if (closingSocket) cancelTimer = later(CLOSE_TIMEOUT, openConnection);
    else openConnection();
  }

  function openConnection(): void {
    cancelTimer();
    closingSocket = null;
    const opening = open(relayOf(page, address), {
      onOpen() {
        if (socket === opening) send({ kind: 'hello', group: address.group, name: address.name, ticket });
      },
      onData(data) {
        if (socket === opening) receive(data);
      },
      onClose(code) {
        if (socket === opening) {
          socket = null;
          end(endOfCode(code, state.kind === 'here'));
        } else if (closingSocket === opening) {
          closingSocket = null;
          if (state.kind === 'joining') openConnection();
        }
      },
    });
    socket = opening;
    cancelTimer = later(WELCOME_TIMEOUT, () => end({ message: 'The room does not answer.', isFinal: false }));
  }

  function receive(data: unknown): void {
    try {
      if (!(data instanceof ArrayBuffer)) throw new FrameError('a message is text instead of bytes');
      const time = now();
      for (const frame of readMessage(new Uint8Array(data))) if (socket) handle(frame, time);
    } catch (error) {
      if (!(error instanceof FrameError)) throw error;
      end({ message: `This page does not understand the server: ${error.message}.`, isFinal: false });
    }
  }

  function handle(frame: FromServer, time: number): void {
    if (frame.kind === 'refused') return end(endOf(frame.reason));
    // Datagrams may overtake frames of the stream.
    if ((frame.kind === 'pose' || frame.kind === 'settled') && state.kind !== 'here') return;
    if ((frame.kind === 'welcome') === (state.kind === 'here')) throw new FrameError('expected one welcome, first');
    if (frame.kind === 'welcome') {
      cancelTimer();
      ticket = frame.ticket;
      connectedAt = time;
      groupMembers.clear();
      newestSequences.clear();
      roundTrips.forget();
      setState({ kind: 'here', user: frame.user });
    } else if (frame.kind === 'joined') {
      newestSequences.set(frame.user, -1);
      if (frame.group === address.group) groupMembers.add(frame.user);
    } else if (frame.kind === 'left') {
      groupMembers.delete(frame.user);
      newestSequences.delete(frame.user);
      // Nobody settles the open round trips now; a later user would settle them too late.
      if (groupMembers.size === 0) roundTrips.forget();
    } else if (frame.kind === 'settled') roundTrips.settle(frame.sequence, time);
    else if (frame.kind === 'pose' && frame.pose.isAcknowledged) {
      send({ kind: 'ack', user: frame.user, sequence: frame.pose.sequence }, !frame.pose.stops);
    }
    if (frame.kind !== 'pose' || isNewest(frame.user, frame.pose.sequence)) onFrame(frame, time);
  }

  /** Whether a pose of a present user is newer than all before: datagrams may overtake each other and the stream. */
  function isNewest(user: number, sequence: number): boolean {
    const newestSequence = newestSequences.get(user);
    if (newestSequence === undefined || sequence <= newestSequence) return false;
    newestSequences.set(user, sequence);
    return true;
  }

  /** Sends a frame; `mayBeLost` if a later frame replaces it. */
  function send(frame: FromUser, mayBeLost = false): void {
    socket?.send(writeFrame(frame), mayBeLost);
  }

  /** Sends a frame; returns false outside the room. */
  function sendInRoom(frame: FromUser): boolean {
    if (state.kind !== 'here' || !socket) return false;
    send(frame);
    return true;
  }

  function closeSocket(isImmediate = false): void {
    cancelTimer();
    if (!socket) return;
    [closingSocket, socket] = [socket, null];
    closingSocket.close(isImmediate);
  }

  function end({ message, isFinal }: End): void {
    const wasStable = state.kind === 'here' && now() - connectedAt >= STABLE_SECONDS;
    closeSocket();
    if (isFinal) return setState({ kind: 'ended', words: message });
    const seconds = wasStable ? MIN_DELAY : delay;
    delay = Math.min(2 * seconds, MAX_DELAY);
    cancelTimer = later(seconds, join);
    setState({ kind: 'waiting', words: message, seconds });
  }

  join();
  return {
    roundTrips,
    get state(): State {
      return state;
    },
    /** Ticket by which the user gets the same number again; empty if there is none. */
    get ticket(): Uint8Array {
      return ticket;
    },
    /** Sends the user's pose; returns false if it cannot be sent now. */
    pose(body: Body, stops: boolean): boolean {
      if (state.kind !== 'here' || !socket || socket.bufferedAmount > MAX_BUFFERED_BYTES) return false;
      const time = now();
      sequence += 1;
      // Only other users can acknowledge a pose.
      const isAcknowledged = groupMembers.size > 0 && roundTrips.send(sequence, time, stops);
      const clock = BigInt(Math.round(1e6 * time));
      send({ kind: 'pose', pose: { ...body, sequence, clock, isAcknowledged, stops } }, !stops);
      return true;
    },
    /** Sends bytes to another user within the limits of docs/rooms.md; returns false outside the room. */
    signal: (user: number, payload: Uint8Array): boolean => sendInRoom({ kind: 'signal', user, payload }),
    /** Sends a message to the group or the room; returns false if it cannot be sent now. */
    say: (payload: Uint8Array, to: Audience): boolean => sendInRoom({ kind: 'say', to, payload }),
    /** Reconnects after the end, or immediately while waiting. */
    retry(): void {
      if (state.kind === 'waiting' || state.kind === 'ended') join();
    },
    /** Leaves the room; immediately if the page is being closed. */
    leave(isImmediate?: boolean): void {
      if (state.kind === 'here') send({ kind: 'bye' });
      closeSocket(isImmediate);
      setState({ kind: 'ended', words: 'You have left the room.' });
    },
  };
}

/** Seconds between two acknowledged poses; greatest number of open round trips. */
const [ACKNOWLEDGE_INTERVAL, MAX_OPEN] = [0.25, 64] as const;
/** Number of round trips for the median. */
const MEDIAN_COUNT = 32;

/** Round trips by Eq. 3 of CloVR (2024): from sending a pose until all others of the group have acknowledged it. */
function createRoundTrips() {
  /** Times of sending by sequence number. */
  const open = new Map<number, number>();
  let last = -Infinity;
  let durations: number[] = [];

  return {
    /** Median of the last round trips, seconds; null before the first. */
    get median(): number | null {
      const sorted = [...durations].sort((a, b) => a - b);
      return sorted[sorted.length >> 1] ?? null;
    },
    /**
     * Records a pose that is about to be sent; returns whether others should acknowledge it. If an earlier pose is still
     * open, the last one before a pause is acknowledged too: otherwise, if the earlier acknowledgement was lost, that
     * round trip would stay open through the pause.
     */
    send(sequence: number, now: number, isLast: boolean): boolean {
      if (now - last < ACKNOWLEDGE_INTERVAL && !(isLast && open.size > 0)) return false;
      last = now;
      const [oldest] = open.keys();
      if (open.size >= MAX_OPEN && oldest !== undefined) open.delete(oldest);
      open.set(sequence, now);
      return true;
    },
    /** Records that all others have acknowledged a pose or a later one. */
    settle(sequence: number, now: number): void {
      for (const [sent, time] of open) {
        if (sent > sequence) continue;
        open.delete(sent);
        durations = [...durations, now - time].slice(-MEDIAN_COUNT);
      }
    },
    /** Discards open round trips, because the connection is a new one. */
    forget(): void {
      open.clear();
      last = -Infinity;
    },
  };
}
