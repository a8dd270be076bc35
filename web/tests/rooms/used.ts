/** Simulates hours in a room within minutes, by a fake server and a fake clock in the page. Not a part of the page. */
import { concatBytes } from '../../src/base/bytes';
import type { Pose as Place } from '../../src/control/pose';
import type { FromServer } from '../../src/rooms/frames';
import { type Body, type Pose, rotationAlong, rotationOf } from '../../src/rooms/pose';
import { randomOf } from '../support/random';
import { encodeFrame } from '../support/rooms';

declare global {
  interface Window {
    used: {
      /** Takes over the clock and the frames of the loaded page. */
      take(): void;
      /** Simulates some seconds of use; returns the number of poses that others have sent so far. */
      run(seconds: number): Promise<number>;
    };
  }
}

/** Number of other users, frames per second, and frames per drawn frame, because software rendering is slow. */
const [OTHERS, RATE, FRAMES_PER_DRAW] = [8, 72, 36] as const;
/** Mean seconds between two events of each kind. */
const PERIODS = { change: 10, say: 2, point: 3, mute: 7, press: 10, breakConnection: 60 } as const;
/** Seconds for which the user presses the key to point. */
const PRESS_SECONDS = 0.5;
const PAYLOAD = new Uint8Array(1024);

let time: number | null = null;
let timers: { readonly number: number; readonly at: number; readonly action: () => void }[] = [];
let lastTimer = 1 << 30;
const real = {
  now: performance.now.bind(performance),
  set: window.setTimeout.bind(window),
  clear: window.clearTimeout.bind(window),
};
performance.now = () => time ?? real.now();
window.setTimeout = ((action: () => void, wait = 0): number => {
  if (time === null) return real.set(action, wait);
  timers.push({ number: ++lastTimer, at: time + wait, action });
  return lastTimer;
}) as typeof window.setTimeout;
window.clearTimeout = (number) => {
  timers = timers.filter((each) => each.number !== number);
  real.clear(number);
};

interface Guest {
  readonly number: number;
  readonly begin: number;
  isPointing: boolean;
  sequence: number;
}

const random = randomOf(1);
let socket: FakeSocket | null = null;
let guests: Guest[] = [];
let lastNumber = 1;
let settledSequence: number | null = null;

/** WebSocket of the page, connected to the fake server. */
class FakeSocket {
  binaryType = 'blob';
  bufferedAmount = 0;
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: ArrayBuffer }) => void) | null = null;
  onclose: ((event: { code: number }) => void) | null = null;

  constructor() {
    window.setTimeout(() => this.onopen?.(), 10);
  }

  send(data: Uint8Array): void {
    if (data[0] === 1) this.welcome();
    const isAcknowledged = data[0] === 2 && ((data[15] ?? 0) & 1) === 1;
    if (isAcknowledged) settledSequence = new DataView(data.buffer, data.byteOffset).getUint32(3, true);
  }

  close(): void {
    if (socket === this) socket = null;
  }

  deliver(frames: readonly FromServer[]): void {
    this.onmessage?.({ data: concatBytes(frames.map(encodeFrame)).buffer });
  }

  private welcome(): void {
    socket = this;
    const others = guests.map(joinedFrame);
    this.deliver([{ kind: 'welcome', user: 60_001, others: others.length, ticket: new Uint8Array(26) }, ...others]);
  }
}
window.WebSocket = FakeSocket as unknown as typeof WebSocket;

function joinedFrame({ number }: Guest): FromServer {
  return { kind: 'joined', user: number, group: 0, name: `User ${number}` };
}

/** Pose of a user after some seconds: on a circle, with both hands. */
function bodyOf({ begin, isPointing }: Guest, seconds: number): Body {
  const angle = 0.3 * seconds + begin;
  const [x, z] = [3 + 2 * Math.sin(angle), -2 - 2 * Math.cos(angle)];
  const hand = (side: number): Body['left'] => ({
    position: [x + 0.2 * side, 1.3, z - 0.3],
    rotation: rotationAlong([Math.sin(angle), -0.1, -1]),
  });
  return {
    head: { position: [x, 1.7, z], rotation: rotationOf(angle, 0.1) },
    left: hand(-1),
    right: hand(1),
    pointer: isPointing ? { begin: 'right', length: 12 } : null,
  };
}

function poseOf(guest: Guest, seconds: number): Pose {
  guest.sequence += 1;
  const isAcknowledged = guest.sequence % 18 === 0;
  const clock = BigInt(Math.round(1e6 * (seconds + guest.begin)));
  return { ...bodyOf(guest, seconds), sequence: guest.sequence, clock, isAcknowledged, stops: false };
}

function createGuest(): Guest {
  lastNumber = (lastNumber % 60_000) + 1;
  return { number: lastNumber, begin: lastNumber, isPointing: false, sequence: 0 };
}

/** Whether an event with a mean period happens in this frame. */
function happens(period: number): boolean {
  return random() < 1 / (period * RATE);
}

function sendKey(name: 'keydown' | 'keyup'): void {
  window.dispatchEvent(new KeyboardEvent(name, { code: 'KeyE', key: 'e', bubbles: true }));
}

function randomItem<Item>(items: readonly Item[]): Item | undefined {
  return items[Math.floor(random() * items.length)];
}

/** Frames that the server sends together. */
function nextFrames(seconds: number): FromServer[] {
  const frames: FromServer[] = guests.map((guest) => ({ kind: 'pose', user: guest.number, pose: poseOf(guest, seconds) }));
  if (settledSequence !== null) frames.push({ kind: 'settled', sequence: settledSequence });
  settledSequence = null;
  if (happens(PERIODS.change)) {
    const [leaving, ...staying] = guests;
    const newGuest = createGuest();
    guests = [...staying, newGuest];
    if (leaving) frames.push({ kind: 'left', user: leaving.number });
    frames.push(joinedFrame(newGuest));
  }
  const guest = randomItem(guests);
  if (guest && happens(PERIODS.say)) frames.push({ kind: 'say', user: guest.number, to: 'room', payload: PAYLOAD });
  if (guest && happens(PERIODS.point / OTHERS)) guest.isPointing = !guest.isPointing;
  return frames;
}

let poses = 0;
let releaseTime = Infinity;

function step(number: number): void {
  const { room, viewer } = window.nearfar ?? {};
  if (!room || !viewer || time === null) throw new Error('the page is in no room');
  time += 1000 / RATE;
  const due = timers.filter(({ at }) => at <= (time ?? 0));
  timers = timers.filter((each) => !due.includes(each));
  for (const { action } of due) action();
  const seconds = time / 1000;
  socket?.deliver(nextFrames(seconds));
  if (socket) poses += guests.length;
  if (socket && happens(PERIODS.breakConnection)) {
    const brokenSocket = socket;
    socket = null;
    brokenSocket.onclose?.({ code: 1006 });
  }
  const muted = randomItem(room.presence.guests);
  if (muted && happens(PERIODS.mute)) room.presence.mute(muted.number, !muted.isMuted);
  if (happens(PERIODS.press)) {
    sendKey('keydown');
    releaseTime = seconds + PRESS_SECONDS;
  }
  if (seconds > releaseTime) {
    sendKey('keyup');
    releaseTime = Infinity;
  }
  const place: Place = { position: [3, 1.7, 1 + Math.sin(0.2 * seconds)], yaw: 0.2 * Math.sin(seconds), pitch: 0 };
  room.frame(place);
  if (number % FRAMES_PER_DRAW === 0) viewer.frame(place, 1 / RATE);
}

window.used = {
  take() {
    window.nearfar?.viewer.renderer.setAnimationLoop(null);
    guests = Array.from({ length: OTHERS }, createGuest);
    time = real.now();
    socket?.deliver(guests.map(joinedFrame));
  },
  async run(seconds) {
    for (let number = 0; number < seconds * RATE; number++) {
      step(number);
      // The page opens sockets in later tasks.
      await Promise.resolve();
    }
    return poses;
  },
};
