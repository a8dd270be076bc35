/** Positions and motion of spheres, aiming tests, and seats of users, from nearfar's random numbers (docs/base.md). */
import { subtract, type Vector } from '../control/pose';
import { type Box, LEVELS, type Rules, type Seat, type Sphere, type Stage } from './messages';

export interface Ray {
  readonly begin: Vector;
  /** A unit vector. */
  readonly direction: Vector;
}

/** Levels of consecutive spheres: easy, hard, intermediate. */
const LEVEL_ORDER = [0, 2, 1] as const;
/** Least distance between seats, metres; greatest number of attempts to achieve it. */
const [MIN_SEAT_DISTANCE, MAX_ATTEMPTS] = [0.7, 32] as const;
/** Number of random numbers reserved for each sphere; index of the first random number for seats. */
const [DRAWS_PER_SPHERE, FIRST_SEAT_DRAW] = [8, 2 ** 32] as const;

/** Creates a trial's sphere from its number. */
export function sphereOf(rules: Rules, stage: Stage, group: number, number: number): Sphere {
  const draw = drawsOf(rules, stage, group, DRAWS_PER_SPHERE * number);
  const [least, most] = rules.box;
  const place = (axis: 0 | 1 | 2): number => least[axis] + draw(axis) * (most[axis] - least[axis]);
  const level = LEVEL_ORDER[number % LEVEL_ORDER.length] ?? 0;
  // The heights of uniformly distributed directions are uniformly distributed (Archimedes).
  const [up, turn, speed] = [2 * draw(3) - 1, 2 * Math.PI * draw(4), rules.speeds[level]];
  const across = speed * Math.sqrt(1 - up * up);
  return {
    kind: 'sphere',
    run: stage.run,
    trial: stage.trial,
    number,
    level: LEVELS[level],
    age: 0,
    position: [place(0), place(1), place(2)],
    velocity: [across * Math.cos(turn), speed * up, across * Math.sin(turn)],
  };
}

/** Assigns random seats to users. */
export function seatsOf(rules: Rules, stage: Stage, group: number, users: readonly number[]): Seat[] {
  const [least, most] = rules.area;
  let seats: Seat[] = [];
  for (let attempt = 0; attempt < MAX_ATTEMPTS; attempt++) {
    const draw = drawsOf(rules, stage, group, FIRST_SEAT_DRAW + 2 * users.length * attempt);
    seats = users.map((user, n) => {
      const [x, z] = [draw(2 * n), draw(2 * n + 1)];
      return { user, position: [least[0] + x * (most[0] - least[0]), least[1], least[2] + z * (most[2] - least[2])] };
    });
    const isApart = seats.every(({ position }, index) =>
      seats.slice(0, index).every((other) => Math.hypot(...subtract(position, other.position)) >= MIN_SEAT_DISTANCE),
    );
    if (isApart) break;
  }
  return seats;
}

/** Position of a sphere's centre some seconds after it appeared. */
export function placeOf({ position, velocity }: Sphere, [least, most]: Box, age: number): Vector {
  const along = (axis: 0 | 1 | 2): number => reflectInto(position[axis] + age * velocity[axis], least[axis], most[axis]);
  return [along(0), along(1), along(2)];
}

/** Reflects a coordinate at both ends of a range until it lies inside. */
export function reflectInto(value: number, low: number, high: number): number {
  const length = high - low;
  if (length <= 0) return low;
  const offset = (((value - low) % (2 * length)) + 2 * length) % (2 * length);
  return low + (offset <= length ? offset : 2 * length - offset);
}

/** Whether a ray of any length hits a sphere. */
export function isAimed({ begin, direction: [dx, dy, dz] }: Ray, center: Vector, radius: number): boolean {
  const [x, y, z] = subtract(center, begin);
  const [along, square] = [x * dx + y * dy + z * dz, x * x + y * y + z * z];
  return square <= radius * radius || (along > 0 && square - along * along <= radius * radius);
}

function drawsOf({ seed }: Rules, { run, trial }: Stage, group: number, first: number): (number: number) => number {
  const cell = group * 2 ** 24 + run * 2 ** 8 + trial;
  return (number) => uniform(seed, cell, first + number);
}

const GOLDEN_GAMMA = 0x9e3779b97f4a7c15n;
const word = (value: bigint): bigint => BigInt.asUintN(64, value);

/** Finaliser of SplitMix64. */
function mixBits(value: bigint): bigint {
  let z = word((value ^ (value >> 30n)) * 0xbf58476d1ce4e5b9n);
  z = word((z ^ (z >> 27n)) * 0x94d049bb133111ebn);
  return z ^ (z >> 31n);
}

/** Random number in [0, 1) (docs/base.md): a function of seed, cell and index, identical in all languages. */
function uniform(seed: number, cell: number, index: number): number {
  let state = mixBits(word(BigInt(seed) + GOLDEN_GAMMA));
  for (const each of [cell, index]) state = mixBits(word((state ^ BigInt(each)) + GOLDEN_GAMMA));
  return Number(state >> 11n) / 2 ** 53;
}
