/** Binary messages of the sphere collection, sent as payloads of a room: the tables of docs/collect.md. */
import type { Vector } from '../control/pose';
import {
  withCheck,
  choiceOf,
  type Codec,
  decode,
  encode,
  F32,
  FrameError,
  kindsOf,
  type MessageOf,
  withPrefix,
  record,
  shortList,
  tuple,
  U16,
  U32,
  U8,
  type ValueOf,
} from '../rooms/bytes';

/** First byte of all messages of the task, and their format version. */
const [MARK, VERSION] = [0xc5, 1] as const;
/** Greatest coordinate in metres, speed in metres per second, and radius in metres. */
const [MAX_COORDINATE, MAX_SPEED, MAX_RADIUS] = [1e6, 100, 1000] as const;
export const MAX_SECONDS = 86400;
/** Greatest number of seated users in a group. */
export const MAX_USERS = 64;
/** Greatest number of spheres and of misses that messages can hold. */
export const MAX_COUNT = 0xffff;

export const LEVELS = ['easy', 'intermediate', 'hard'] as const;

const flag = choiceOf([false, true], 'a code is unknown');
const level = choiceOf(LEVELS, 'a code is unknown');
/** Events reported by `aims`; `told` reports the state without an event. */
const event = choiceOf(['told', 'selected', 'lost'], 'a code is unknown');
const seconds = numberWithin(0, MAX_SECONDS);
const speed = numberWithin(0, MAX_SPEED);
const position = vectorWithin(MAX_COORDINATE);
/** Least and greatest coordinates. */
const BOX = tuple(position, position);
/** Collected spheres of a level, their misses, and the sum of their times. */
const TALLY = record({ spheres: U16, misses: U16, seconds });
/** Seat of a user: position of the eyes, metres from the scene's origin. */
const SEAT = record({ user: U16, position });
/** Seconds for which all required users have aimed; null while some do not. */
const held: Codec<number | null> = {
  read(from) {
    const value = F32.read(from);
    if (value !== -1) checkRange(value, 0, MAX_SECONDS);
    return value === -1 ? null : value;
  },
  write: (out, value) => F32.write(out, value ?? -1),
};
/** Users who aim, in ascending order. */
const users = withCheck(shortList(U16), (numbers) => {
  const isAscending = numbers.every((user, index) => index === 0 || user > (numbers[index - 1] ?? 0));
  if (numbers.length > MAX_USERS || !isAscending) throw new FrameError('the users who aim are not in ascending order');
});

/** Run and trial of a message; each run of a group has a greater number than the run before. */
const STAGE = { run: U16, trial: U8 } as const;

const TRIAL = record({
  ...STAGE,
  trials: U8,
  over: flag,
  /** Number of users who must aim at once. */
  users: U8,
  seed: U32,
  /** Seconds since the start of the trial, and its duration. */
  elapsed: seconds,
  duration: seconds,
  /** Seconds for which all must aim; between a collected sphere and the next one; between trials. */
  hold: seconds,
  pause: seconds,
  rest: seconds,
  radius: numberWithin(0, MAX_RADIUS),
  /** Speeds by level, metres per second. */
  speeds: tuple(speed, speed, speed),
  /** Boxes of sphere centres and of seats. */
  box: BOX,
  area: BOX,
  tallies: tuple(TALLY, TALLY, TALLY),
  seats: shortList(SEAT),
});

const SPHERE = record({
  ...STAGE,
  number: U16,
  level,
  /** Seconds since the sphere appeared at its position. */
  age: seconds,
  position,
  velocity: vectorWithin(MAX_SPEED),
});

const KINDS = {
  trial: [1, withCheck(TRIAL, checkTrial)],
  sphere: [2, SPHERE],
  aims: [3, record({ ...STAGE, number: U16, event, user: U16, misses: U16, held, users })],
  collected: [4, record({ ...STAGE, number: U16, level, misses: U16, seconds })],
  score: [5, record({ ...STAGE, over: flag, spheres: U16, misses: U16 })],
} as const;
const MESSAGE = withPrefix(
  MARK,
  'a message is not of the sphere collection',
  withPrefix(
    VERSION,
    'a message of the sphere collection has another version',
    kindsOf(KINDS, 'a message of the sphere collection has an unknown kind'),
  ),
);

export type Message = MessageOf<typeof KINDS>;
export type Trial = Message & { readonly kind: 'trial' };
export type Sphere = Message & { readonly kind: 'sphere' };
export type Aims = Message & { readonly kind: 'aims' };
export type Collected = Message & { readonly kind: 'collected' };
export type Score = Message & { readonly kind: 'score' };
export type Event = Aims['event'];
export type Stage = Pick<Trial, 'run' | 'trial'>;
export type Tally = ValueOf<typeof TALLY>;
export type Tallies = Trial['tallies'];
export type Seat = ValueOf<typeof SEAT>;
export type Box = ValueOf<typeof BOX>;
export type Rules = Omit<Trial, 'kind' | keyof Stage | 'over' | 'elapsed' | 'tallies' | 'seats'>;

function numberWithin(low: number, high: number): Codec<number> {
  return withCheck(F32, (value) => checkRange(value, low, high));
}

function vectorWithin(greatest: number): Codec<Vector> {
  const coordinate = numberWithin(-greatest, greatest);
  return tuple(coordinate, coordinate, coordinate);
}

function checkRange(value: number, low: number, high: number): void {
  // NaN fails the comparison.
  if (!(value >= low && value <= high)) throw new FrameError('a number is out of its range');
}

function checkTrial({ trial, trials, users, duration, radius, box, area, seats }: ValueOf<typeof TRIAL>): void {
  const isOrdered = [box, area].every(([least, most]) => least.every((low, axis) => low <= (most[axis] ?? low)));
  const isPossible = trial >= 1 && trial <= trials && users >= 1 && users <= MAX_USERS;
  if (!isPossible || seats.length > MAX_USERS || radius === 0 || duration === 0 || !isOrdered)
    throw new FrameError('a trial has rules out of range');
}

/** Recipients of a message: the room for scores, the group for all others. */
export function audienceOf({ kind }: Message): 'group' | 'room' {
  return kind === 'score' ? 'room' : 'group';
}

export function write(message: Message): Uint8Array {
  return encode(MESSAGE, message);
}

/** Decodes a payload; null if it is not a message of the task; throws `FrameError` if it is a damaged one. */
export function read(bytes: Uint8Array): Message | null {
  return bytes[0] === MARK ? decode(MESSAGE, bytes, 'a message of the sphere collection is too long') : null;
}

/** Whether two messages belong to the same trial. */
export function isSameStage(a: Stage, b: Stage): boolean {
  return a.run === b.run && a.trial === b.trial;
}

/** Number of spheres collected in a trial. */
export function countOf({ tallies }: Trial): number {
  return tallies.reduce((sum, { spheres }) => sum + spheres, 0);
}

/** Whether the message `a` about a trial is older than `b`. */
export function isEarlier(a: Trial, b: Trial): boolean {
  // Run numbers are cyclic.
  const ahead = (a.run - b.run) & MAX_COUNT;
  if (ahead !== 0) return ahead > MAX_COUNT / 2;
  const progressOf = (trial: Trial): number[] => [trial.trial, Number(trial.over), countOf(trial)];
  const [progressA, progressB] = [progressOf(a), progressOf(b)];
  const index = progressA.findIndex((value, n) => value !== progressB[n]);
  return index >= 0 && (progressA[index] ?? 0) < (progressB[index] ?? 0);
}
