/** Requests for views: the most wanted first, cancelled when nobody wants them, asked again if that may help. */
import { type Failure, isPassing } from '../store/error';

/** Seconds until a view that failed is asked for again: doubled each time. */
const [SOONEST, LATEST] = [1, 30] as const;

/** Stands for all failures that pass: a server that is gone fails for each view. */
const PASSING = '';

export interface QueueSettings<Job> {
  /** Views that are asked for at once. */
  readonly atOnce: number;
  send(id: number, job: Job): void;
  cancel(id: number): void;
  /** A view failed; told once for each message, and once for all that may help themselves. */
  failed(failure: Failure): void;
  /** A view has come after some failed in passing. */
  recovered(): void;
  now(): number;
}

interface Running<Job> {
  readonly name: string;
  readonly job: Job;
  isCancelled: boolean;
}

interface Failed {
  readonly again: number;
  readonly pause: number;
}

export class Queue<Job> {
  readonly #running = new Map<number, Running<Job>>();
  /** Names of views that failed, and when they are asked for again. */
  readonly #failed = new Map<string, Failed>();
  readonly #told = new Set<string>();
  #wanted = new Map<string, Job>();
  #last = 0;

  constructor(readonly settings: QueueSettings<Job>) {}

  /** Number of views that are waited for, without those that failed for good. */
  get waiting(): number {
    return [...this.#wanted.keys()].filter((name) => this.#failed.get(name)?.again !== Number.POSITIVE_INFINITY).length;
  }

  /** From now on want these views and no others, the first one most. */
  want(wanted: Map<string, Job>): void {
    this.#wanted = wanted;
    for (const [id, running] of this.#running) {
      if (running.isCancelled || wanted.has(running.name)) continue;
      running.isCancelled = true;
      this.settings.cancel(id);
    }
    this.fill();
  }

  /** Ask for what is wanted, as far as there is room. */
  fill(): void {
    const busy = new Set([...this.#running.values()].map(({ name }) => name));
    const now = this.settings.now();
    for (const [name, job] of this.#wanted) {
      if (this.#running.size >= this.settings.atOnce) return;
      if (busy.has(name) || (this.#failed.get(name)?.again ?? 0) > now) continue;
      const id = ++this.#last;
      this.#running.set(id, { name, job, isCancelled: false });
      this.settings.send(id, job);
    }
  }

  /** A view has come; null if nobody knows it. */
  done(id: number): Job | null {
    const found = this.#end(id);
    if (found) {
      this.#failed.delete(found.name);
      this.#wanted.delete(found.name);
      if (this.#told.delete(PASSING)) this.settings.recovered();
    }
    return found?.job ?? null;
  }

  /** A request has ended because nobody wanted it. */
  cancelled(id: number): void {
    this.#end(id);
    this.fill();
  }

  /** A view failed; the job, if it is not asked for again. */
  failed(id: number, failure: Failure): Job | null {
    const found = this.#end(id);
    if (found) {
      const pause = Math.min(2 * (this.#failed.get(found.name)?.pause ?? SOONEST / 2), LATEST);
      const again = isPassing(failure) ? this.settings.now() + pause : Number.POSITIVE_INFINITY;
      this.#failed.set(found.name, { again, pause });
      const told = isPassing(failure) ? PASSING : failure.message;
      if (!this.#told.has(told)) this.settings.failed(failure);
      this.#told.add(told);
    }
    this.fill();
    return isPassing(failure) ? null : (found?.job ?? null);
  }

  /** Ask again for all that failed. */
  retry(): void {
    this.#failed.clear();
    this.#told.clear();
    this.fill();
  }

  #end(id: number): Running<Job> | null {
    const found = this.#running.get(id);
    this.#running.delete(id);
    return found ?? null;
  }
}
