/** State of the task as one user knows it, and the conductor's messages. Independent of the room and the clock. */
import type { Vector } from '../control/pose';
import { createBucket } from '../rooms/clock';
import { type Aiming, aimsOf, judge, type Rays } from './judge';
import type { Aims, Collected, Message, Rules, Score, Sphere, Stage, Tallies, Trial } from './messages';
import { countOf, isEarlier, isSameStage, LEVELS, MAX_SECONDS, MAX_COUNT, MAX_USERS } from './messages';
import { placeOf, seatsOf, sphereOf } from './spheres';

/** Least seconds from a collected sphere to the next sphere; bounds the conductor's message rate for any rules. */
const MIN_PAUSE = 0.05;
/** Least seconds between two judgements: less than the interval of a user's poses, each of which may cause one. */
const MIN_JUDGEMENT_INTERVAL = 1 / 80;
/** Rate of `aims` in bytes per second, half of the room's limit, and burst size in bytes. */
const [AIMS_RATE, AIMS_AT_ONCE] = [1 << 14, 1 << 13] as const;
/** Bytes of `aims` without users, for which the room counts at least this many; additional bytes per user. */
const [AIMS_BYTES, USER_BYTES] = [64, 2] as const;
/** Seconds after entering during which every sender is accepted, because the conductor is still unknown. */
const ENTRY_SECONDS = 5;

const NO_TALLIES: Tallies = [0, 1, 2].map(() => ({ spheres: 0, misses: 0, seconds: 0 })) as unknown as Tallies;

/** Task of a group. Times are seconds on the caller's clock; `now` of a message is the time of its arrival. */
export class Task {
  /** Users of the group who are connected. */
  readonly present = new Set<number>();
  /** Last scores by group. */
  readonly scores = new Map<number, Score>();
  trial: Trial | null = null;
  sphere: Sphere | null = null;
  /** Users who aim at the sphere, in ascending order, and its misses. */
  aims: readonly number[] = [];
  misses = 0;
  /** Time since which all required users have aimed; null while some do not. */
  heldSince: number | null = null;
  private startedAt = 0;
  private appearedAt = 0;
  private nextSphereAt = 0;
  private mustSendState = false;
  private judgedAt = -Infinity;
  private readonly aimsRate = createBucket(AIMS_RATE, AIMS_AT_ONCE, () => this.judgedAt);
  /** Conductor before the last user joined, whose last messages may still arrive. */
  private formerConductor: number | null = null;
  /** Time until which every sender is accepted; null until the first call after entering. */
  private enteredUntil: number | null = null;

  constructor(readonly user: number, readonly group: number) {
    this.present.add(user);
  }

  /** User who creates and judges spheres: the lowest number among present seated users, or else among all present. */
  get conductor(): number {
    const playing = this.seated();
    return Math.min(...(playing.length > 0 ? playing : this.present));
  }

  /**
   * Number of users who must aim at once: that of the trial, or of present seated users if these are fewer; at least 2.
   */
  get needed(): number {
    return this.trial ? Math.min(this.trial.users, Math.max(this.seated().length, 2)) : 0;
  }

  /** Whether the last trial has ended. */
  get isOver(): boolean {
    return this.trial !== null && this.trial.over && this.trial.trial === this.trial.trials;
  }

  /** Position of the user's eyes in the seat; null without a seat. */
  get seat(): Vector | null {
    return this.trial?.seats.find(({ user }) => user === this.user)?.position ?? null;
  }

  /** Number of spheres collected in the trial, which is the number of the next sphere. */
  get count(): number {
    return this.trial ? countOf(this.trial) : 0;
  }

  /** Misses of the trial's collected spheres. */
  get collectedMisses(): number {
    return Math.min(this.trial?.tallies.reduce((sum, { misses }) => sum + misses, 0) ?? 0, MAX_COUNT);
  }

  elapsed(now: number): number {
    return now - this.startedAt;
  }

  /** Position of the sphere's centre; null without a sphere. */
  place(now: number): Vector | null {
    return this.trial && this.sphere && placeOf(this.sphere, this.trial.box, now - this.appearedAt);
  }

  /** Records that a user of the group has joined; the conductor then sends the state. */
  addUser(user: number): void {
    const before = this.conductor;
    if (this.trial && before === this.user) this.mustSendState = true;
    this.present.add(user);
    if (this.conductor !== before) this.formerConductor = before;
  }

  removeUser(user: number): void {
    if (user !== this.user) this.present.delete(user);
    if (user === this.formerConductor) this.formerConductor = null;
  }

  /** Forgets the other users after a broken connection, which announces them again; keeps the state of the task. */
  resetUsers(): void {
    this.present.clear();
    this.present.add(this.user);
    this.forgetScores((group) => group === this.group);
    [this.formerConductor, this.enteredUntil] = [null, null];
  }

  /** Discards the scores of groups without users. */
  forgetScores(hasUsers: (group: number) => boolean): void {
    for (const group of [...this.scores.keys()]) if (!hasUsers(group)) this.scores.delete(group);
  }

  /** Begins the first trial of a run for all users who are present; returns the conductor's messages. */
  start(rules: Rules, now: number): Message[] {
    const run = this.trial ? (this.trial.run + 1) % (MAX_COUNT + 1) : 1;
    return this.apply(this.createTrial(rules, { run, trial: 1 }), now);
  }

  /**
   * Messages of this user as the conductor, already applied to the own state; none if another user is the conductor.
   */
  conduct(now: number, rays: Rays): Message[] {
    this.enteredUntil ??= now + ENTRY_SECONDS;
    const messages = this.mustSendState ? this.stateMessages(now) : [];
    this.mustSendState = false;
    const isDue = now - this.judgedAt >= MIN_JUDGEMENT_INTERVAL;
    if (isDue) this.judgedAt = now;
    while (this.user === this.conductor) {
      const message = this.decide(now, isDue ? rays : null);
      if (!message) break;
      // The server disconnects users who exceed its limit of bytes.
      if (message.kind === 'aims' && !this.aimsRate.take(AIMS_BYTES + USER_BYTES * message.users.length)) break;
      const applied = this.apply(message, now);
      // A message that changes nothing would be chosen again and again.
      if (applied.length === 0) break;
      messages.push(...applied);
    }
    return messages;
  }

  /**
   * Applies a message; returns whether it had an effect. Messages about an earlier run, trial or sphere are ignored,
   * and messages about a trial from users other than its conductor.
   */
  hear(message: Message, now: number, sender = this.user, group = this.group): boolean {
    if (message.kind === 'score') {
      this.scores.set(group, message);
      return true;
    }
    this.enteredUntil ??= now + ENTRY_SECONDS;
    if (group !== this.group || !this.accepts(sender, now)) return false;
    if (message.kind === 'trial') {
      if (this.trial && isEarlier(message, this.trial)) return false;
      this.hearTrial(message, now);
      return true;
    }
    if (!this.trial || this.trial.over || !isSameStage(message, this.trial)) return false;
    return this.hearPlay(message, this.trial, now);
  }

  /**
   * Whether a sender may conduct. Without seated users any user may begin; if two begin at once, the lower number wins.
   */
  private accepts(sender: number, now: number): boolean {
    if (sender === this.user || this.enteredUntil === null || now < this.enteredUntil) return true;
    return this.seated().length === 0 || sender <= this.conductor || sender === this.formerConductor;
  }

  private hearTrial(trial: Trial, now: number): void {
    const isOther = !this.trial || !isSameStage(trial, this.trial) || trial.over;
    // A user who returns during a pause may know a sphere that was collected meanwhile.
    const isCollected = this.sphere !== null && this.sphere.number < countOf(trial);
    if (isOther || isCollected) {
      this.sphere = null;
      this.nextSphereAt = trial.elapsed === 0 ? now : now + Math.max(trial.pause, MIN_PAUSE);
      this.clearAims();
    }
    this.trial = trial;
    this.startedAt = now - trial.elapsed;
  }

  private hearPlay(message: Sphere | Aims | Collected, trial: Trial, now: number): boolean {
    const known = this.sphere?.number ?? -1;
    if (message.kind === 'sphere') {
      // The count must leave room for the sphere's collection.
      if (message.number === known || message.number !== this.count || message.number >= MAX_COUNT) return false;
      this.sphere = message;
      this.appearedAt = now - message.age;
      this.clearAims();
    } else if (message.kind === 'aims') {
      if (message.number !== known) return false;
      this.aims = message.users;
      this.misses = message.misses;
      this.heldSince = message.held === null ? null : now - message.held;
    } else {
      if (message.number !== this.count || message.number >= MAX_COUNT) return false;
      this.hearCollected(message, trial, now);
    }
    return true;
  }

  private hearCollected({ level, misses, seconds }: Collected, trial: Trial, now: number): void {
    const tallies = trial.tallies.map((tally, index) => {
      if (LEVELS[index] !== level) return tally;
      return {
        spheres: tally.spheres + 1,
        misses: Math.min(tally.misses + misses, MAX_COUNT),
        seconds: Math.min(tally.seconds + seconds, MAX_SECONDS),
      };
    });
    this.trial = { ...trial, tallies: tallies as unknown as Tallies };
    this.sphere = null;
    this.nextSphereAt = now + Math.max(trial.pause, MIN_PAUSE);
    this.clearAims();
  }

  private clearAims(): void {
    this.aims = [];
    this.misses = 0;
    this.heldSince = null;
  }

  private seated(): number[] {
    return this.trial?.seats.map(({ user }) => user).filter((user) => this.present.has(user)) ?? [];
  }

  /** Applies a message of this user; returns it with the resulting score, or nothing if it has no effect. */
  private apply(message: Message, now: number): Message[] {
    if (!this.hear(message, now)) return [];
    if (!this.trial || (message.kind !== 'trial' && message.kind !== 'collected')) return [message];
    const { run, trial, over } = this.trial;
    const score: Score = { kind: 'score', run, trial, over, spheres: Math.min(this.count, MAX_COUNT), misses: this.collectedMisses };
    this.hear(score, now);
    return [message, score];
  }

  /** Messages that a new user needs. */
  private stateMessages(now: number): Message[] {
    if (!this.trial) return [];
    const messages: Message[] = [{ ...this.trial, elapsed: Math.min(this.elapsed(now), MAX_SECONDS) }];
    if (this.sphere) {
      messages.push({ ...this.sphere, age: Math.min(now - this.appearedAt, MAX_SECONDS) });
      messages.push(aimsOf(this.aimingAt(this.sphere, now), 'told', 0, this.aims));
    }
    return messages;
  }

  private createTrial(rules: Rules, stage: Stage): Trial {
    const users = [...this.present].sort((a, b) => a - b).slice(0, MAX_USERS);
    const seats = seatsOf(rules, stage, this.group, users);
    return { ...rules, ...stage, kind: 'trial', over: false, elapsed: 0, tallies: NO_TALLIES, seats };
  }

  /** Next message that the state requires, or null. Without rays, aims are not judged. */
  private decide(now: number, rays: Rays | null): Message | null {
    const { trial, sphere } = this;
    if (!trial) return null;
    const elapsed = this.elapsed(now);
    if (trial.over) {
      const isNext = trial.trial < trial.trials && elapsed >= trial.duration + trial.rest;
      return isNext ? this.createTrial(trial, { run: trial.run, trial: trial.trial + 1 }) : null;
    }
    if (elapsed >= trial.duration) return { ...trial, over: true, elapsed: Math.min(elapsed, MAX_SECONDS) };
    if (sphere) return rays && judge(this.aimingAt(sphere, now), trial, rays);
    return now >= this.nextSphereAt && this.count < MAX_COUNT ? sphereOf(trial, trial, this.group, this.count) : null;
  }

  private aimingAt(sphere: Sphere, now: number): Aiming {
    const { aims, misses, needed, heldSince, present } = this;
    const held = heldSince === null ? null : now - heldSince;
    return { sphere, age: now - this.appearedAt, aims, misses, needed, held, present, seated: this.seated() };
  }
}
