/** Binary messages of the sphere collection, sent as payloads of a room: the tables of docs/collect.md. */
import type { Vector } from '../control/pose';
import { FrameError, Reader, Writer } from '../rooms/bytes';

/** First byte of all messages of the task, and their format version. */
const [MARK, VERSION] = [0xc5, 1] as const;
/** Greatest coordinate, speed, radius and time, in metres and seconds. */
const [FARTHEST, FASTEST, LARGEST] = [1e6, 100, 1000] as const;
export const LONGEST = 86400;
/** Greatest number of seated users in a group. */
export const MAX_USERS = 64;
/** Greatest number of spheres and of misses that messages can hold. */
export const MAX_COUNT = 0xffff;

/** Levels and reasons in the order of their codes; `told` for all reasons without an event. */
export const LEVELS = ['easy', 'intermediate', 'hard'] as const;
export type Level = (typeof LEVELS)[number];
const EVENTS = ['told', 'selected', 'lost'] as const;
export type Event = (typeof EVENTS)[number];

/** Run and trial that a message belongs to; a group's next run has a greater number. */
export interface Stage {
  readonly run: number;
  readonly trial: number;
}

export interface Seat {
  readonly user: number;
  /** Position of the eyes, metres from the scene's origin. */
  readonly position: Vector;
}

/** Collected spheres of a level, and the sum of their times. */
export interface Tally {
  readonly spheres: number;
  readonly misses: number;
  readonly seconds: number;
}
export type Tallies = readonly [Tally, Tally, Tally];

/** Least and greatest coordinates. */
export type Box = readonly [Vector, Vector];

export interface Rules {
  readonly trials: number;
  readonly users: number;
  readonly seed: number;
  readonly duration: number;
  /** Seconds for which all must aim; between a collected sphere and the next one; between trials. */
  readonly hold: number;
  readonly pause: number;
  readonly rest: number;
  readonly radius: number;
  /** Speeds by level, metres per second. */
  readonly speeds: Vector;
  /** Boxes of sphere centres and of seats. */
  readonly box: Box;
  readonly area: Box;
}

export interface Trial extends Stage, Rules {
  readonly kind: 'trial';
  readonly over: boolean;
  /** Seconds since its start. */
  readonly elapsed: number;
  readonly tallies: Tallies;
  readonly seats: readonly Seat[];
}

export interface Sphere extends Stage {
  readonly kind: 'sphere';
  readonly number: number;
  readonly level: Level;
  /** Seconds since it appeared at its position. */
  readonly age: number;
  readonly position: Vector;
  readonly velocity: Vector;
}

export interface Aims extends Stage {
  readonly kind: 'aims';
  readonly number: number;
  readonly event: Event;
  readonly user: number;
  readonly misses: number;
  /** Seconds for which all required users have aimed; null while some do not. */
  readonly held: number | null;
  readonly users: readonly number[];
}

export interface Collected extends Stage {
  readonly kind: 'collected';
  readonly number: number;
  readonly level: Level;
  readonly misses: number;
  readonly seconds: number;
}

export interface Score extends Stage {
  readonly kind: 'score';
  readonly over: boolean;
  readonly spheres: number;
  readonly misses: number;
}

export type Message = Trial | Sphere | Aims | Collected | Score;

const KINDS = { trial: 1, sphere: 2, aims: 3, collected: 4, score: 5 } as const;

/** Recipients of a message: the room for scores, else the group. */
export function audienceOf({ kind }: Message): 'group' | 'room' {
  return kind === 'score' ? 'room' : 'group';
}

export function write(message: Message): Uint8Array {
  const out = new Writer();
  for (const value of [MARK, VERSION, KINDS[message.kind]]) out.u8(value);
  out.u16(message.run);
  out.u8(message.trial);
  if (message.kind === 'trial') writeTrial(out, message);
  else if (message.kind === 'score') {
    out.u8(Number(message.over));
    out.u16(message.spheres);
    out.u16(message.misses);
  } else {
    out.u16(message.number);
    writePlay(out, message);
  }
  return out.toBytes();
}

function writeTrial(out: Writer, trial: Trial): void {
  for (const value of [trial.trials, Number(trial.over), trial.users]) out.u8(value);
  out.u32(trial.seed);
  const { elapsed, duration, hold, pause, rest, radius } = trial;
  floats(out, [elapsed, duration, hold, pause, rest, radius], trial.speeds, ...trial.box, ...trial.area);
  for (const { spheres, misses, seconds } of trial.tallies) {
    out.u16(spheres);
    out.u16(misses);
    out.f32(seconds);
  }
  out.u8(trial.seats.length);
  for (const { user, position } of trial.seats) {
    out.u16(user);
    floats(out, position);
  }
}

function writePlay(out: Writer, message: Sphere | Aims | Collected): void {
  if (message.kind === 'sphere') {
    out.u8(LEVELS.indexOf(message.level));
    floats(out, [message.age], message.position, message.velocity);
  } else if (message.kind === 'aims') {
    out.u8(EVENTS.indexOf(message.event));
    out.u16(message.user);
    out.u16(message.misses);
    out.f32(message.held ?? -1);
    out.u8(message.users.length);
    for (const user of message.users) out.u16(user);
  } else {
    out.u8(LEVELS.indexOf(message.level));
    out.u16(message.misses);
    out.f32(message.seconds);
  }
}

/** Decodes a payload; null if it is not a message of the task, throws `FrameError` for a damaged message. */
export function read(bytes: Uint8Array): Message | null {
  if (bytes[0] !== MARK) return null;
  const body = new Reader(bytes.subarray(1));
  if (body.u8() !== VERSION) throw new FrameError('a message of the sphere collection has another version');
  const kind = body.u8();
  const message = readBody(body, kind, { run: body.u16(), trial: body.u8() });
  body.expectEnd('a message of the sphere collection is too long');
  return message;
}

function readBody(body: Reader, kind: number, stage: Stage): Message {
  switch (kind) {
    case KINDS.trial:
      return readTrial(body, stage);
    case KINDS.sphere: {
      const [number, level, age] = [body.u16(), readName(body, LEVELS), readWithin(body, 0, LONGEST)];
      const [position, velocity] = [readVector(body, FARTHEST), readVector(body, FASTEST)];
      return { kind: 'sphere', ...stage, number, level, age, position, velocity };
    }
    case KINDS.aims:
      return readAims(body, stage);
    case KINDS.collected: {
      const [number, level, misses] = [body.u16(), readName(body, LEVELS), body.u16()];
      return { kind: 'collected', ...stage, number, level, misses, seconds: readWithin(body, 0, LONGEST) };
    }
    case KINDS.score:
      return { kind: 'score', ...stage, over: readFlag(body), spheres: body.u16(), misses: body.u16() };
    default:
      throw new FrameError('a message of the sphere collection has an unknown kind');
  }
}

function readTrial(body: Reader, stage: Stage): Trial {
  const [trials, over, users, seed] = [body.u8(), readFlag(body), body.u8(), body.u32()];
  const time = (): number => readWithin(body, 0, LONGEST);
  const [elapsed, duration, hold, pause, rest] = [time(), time(), time(), time(), time()];
  const radius = readWithin(body, 0, LARGEST);
  const speed = (): number => readWithin(body, 0, FASTEST);
  const speeds = [speed(), speed(), speed()] as const;
  const corner = (): Vector => readVector(body, FARTHEST);
  const [box, area]: [Box, Box] = [[corner(), corner()], [corner(), corner()]];
  const tally = (): Tally => ({ spheres: body.u16(), misses: body.u16(), seconds: time() });
  const tallies = [tally(), tally(), tally()] as const;
  const count = body.u8();
  const seats = Array.from({ length: count }, (): Seat => ({ user: body.u16(), position: corner() }));
  const isOrdered = [box, area].every(([least, most]) => least.every((low, axis) => low <= (most[axis] ?? low)));
  const isPossible = stage.trial >= 1 && stage.trial <= trials && users >= 1 && users <= MAX_USERS;
  if (!isPossible || count > MAX_USERS || radius === 0 || duration === 0 || !isOrdered) {
    throw new FrameError('a trial has rules out of range');
  }
  const rules = { trials, users, seed, duration, hold, pause, rest, radius, speeds, box, area };
  return { kind: 'trial', ...stage, ...rules, over, elapsed, tallies, seats };
}

function readAims(body: Reader, stage: Stage): Aims {
  const [number, event, user, misses] = [body.u16(), readName(body, EVENTS), body.u16(), body.u16()];
  const time = body.f32();
  const users = Array.from({ length: body.u8() }, () => body.u16());
  if (users.length > MAX_USERS || users.some((each, at) => at > 0 && each <= (users[at - 1] ?? 0))) {
    throw new FrameError('the users who aim are not in ascending order');
  }
  const held = time === -1 ? null : checkRange(time, 0, LONGEST);
  return { kind: 'aims', ...stage, number, event, user, misses, held, users };
}

function readName<Name>(body: Reader, names: readonly Name[]): Name {
  const name = names[body.u8()];
  if (name === undefined) throw new FrameError('a code is unknown');
  return name;
}

function readFlag(body: Reader): boolean {
  return readName(body, [false, true]);
}

function readVector(body: Reader, most: number): Vector {
  return [readWithin(body, -most, most), readWithin(body, -most, most), readWithin(body, -most, most)];
}

function readWithin(body: Reader, low: number, high: number): number {
  return checkRange(body.f32(), low, high);
}

function checkRange(value: number, low: number, high: number): number {
  // NaN fails the comparison.
  if (!(value >= low && value <= high)) throw new FrameError('a number is out of its range');
  return value;
}

function floats(out: Writer, ...lists: readonly (readonly number[])[]): void {
  for (const value of lists.flat()) out.f32(value);
}

/** Whether two messages belong to the same trial. */
export function isSameStage(a: Stage, b: Stage): boolean {
  return a.run === b.run && a.trial === b.trial;
}

/** Number of spheres collected in a trial. */
export function countOf({ tallies }: Trial): number {
  return tallies.reduce((sum, { spheres }) => sum + spheres, 0);
}

/** Whether a message about a trial is older than another one. */
export function isEarlier(a: Trial, b: Trial): boolean {
  // Run numbers are cyclic.
  const ahead = (a.run - b.run) & MAX_COUNT;
  if (ahead !== 0) return ahead > MAX_COUNT / 2;
  const age = (trial: Trial): number[] => [trial.trial, Number(trial.over), countOf(trial)];
  const [own, other] = [age(a), age(b)];
  const at = own.findIndex((value, place) => value !== other[place]);
  return at >= 0 && (own[at] ?? 0) < (other[at] ?? 0);
}
