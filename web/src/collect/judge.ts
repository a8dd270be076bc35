/** Judgement by the conductor: which users aim at the sphere or have lost it, and whether it is collected. */
import { type Aims, type Collected, type Event, MAX_SECONDS, MAX_COUNT, type Sphere, type Trial } from './messages';
import { isAimed, placeOf, type Ray } from './spheres';

/** Latest pointer rays by the number of the user; users without a pointer have no entry. */
export type Rays = ReadonlyMap<number, Ray>;

/** State of the aiming at a sphere. */
export interface Aiming {
  readonly sphere: Sphere;
  /** Seconds since the sphere appeared. */
  readonly age: number;
  /** Users who aim at it, in ascending order, and its misses. */
  readonly aims: readonly number[];
  readonly misses: number;
  /** Number of users who must aim at once; seconds for which they have done so, null while some do not. */
  readonly needed: number;
  readonly held: number | null;
  readonly present: ReadonlySet<number>;
  readonly seated: readonly number[];
}

/** Returns a message about one change of the aiming, or about the sphere's collection; null if nothing has changed. */
export function judge(aiming: Aiming, trial: Trial, rays: Rays): Aims | Collected | null {
  const { sphere, age, aims, misses, needed, held, present, seated } = aiming;
  const center = placeOf(sphere, trial.box, age);
  const aimingUsers = seated.filter((user) => {
    const ray = rays.get(user);
    return ray !== undefined && isAimed(ray, center, trial.radius);
  });
  const lostUser = aims.find((user) => !aimingUsers.includes(user));
  if (lostUser !== undefined) {
    const users = aims.filter((user) => user !== lostUser);
    // A user who has left the room does not count as a miss.
    return aimsOf(aiming, present.has(lostUser) ? 'lost' : 'told', lostUser, users);
  }
  const [joinedUser] = aimingUsers.filter((user) => !aims.includes(user)).sort((a, b) => a - b);
  if (joinedUser !== undefined) {
    const users = [...aims, joinedUser].sort((a, b) => a - b);
    return aimsOf(aiming, 'selected', joinedUser, users);
  }
  if (aims.length >= needed !== (held !== null)) return aimsOf(aiming, 'told', 0, aims);
  if (held === null || held < trial.hold) return null;
  const { run, trial: trialNumber } = trial;
  const { number, level } = sphere;
  return { kind: 'collected', run, trial: trialNumber, number, level, misses, seconds: Math.min(age, MAX_SECONDS) };
}

/** Message that `users` aim at the sphere, after an event of one user. */
export function aimsOf(aiming: Aiming, event: Event, user: number, users: readonly number[]): Aims {
  const { run, trial, number } = aiming.sphere;
  const held = users.length >= aiming.needed ? Math.min(aiming.held ?? 0, MAX_SECONDS) : null;
  const misses = Math.min(aiming.misses + Number(event === 'lost'), MAX_COUNT);
  return { kind: 'aims', run, trial, number, event, user, misses, held, users };
}
