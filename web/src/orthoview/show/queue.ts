/** Requests for views: highest priority first, cancelled when no longer wanted, retried if that may help. */
import { type Failure, isPassing } from '../store/error';

/** Least and greatest delay before a failed view is requested again, seconds; the delay doubles each time. */
const [SOONEST, LATEST] = [1, 30] as const;

/** Key of all temporary failures: an unreachable server fails for each view. */
const PASSING = '';

export interface QueueSettings<Job> {
  /** Number of concurrent requests. */
  readonly atOnce: number;
  send(id: number, job: Job): void;
  cancel(id: number): void;
  /** Called when a view failed: once per message, and once for all temporary failures. */
  failed(failure: Failure): void;
  /** Called when a view arrives after temporary failures. */
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
  /** Failed views by name, with the time of their next request. */
  readonly #failed = new Map<string, Failed>();
  readonly #told = new Set<string>();
  #wanted = new Map<string, Job>();
  #last = 0;

  constructor(readonly settings: QueueSettings<Job>) {}

  /** Number of outstanding views, without those that failed permanently. */
  get waiting(): number {
    return [...this.#wanted.keys()].filter((name) => this.#failed.get(name)?.again !== Number.POSITIVE_INFINITY).length;
  }

  /** Replaces the wanted views; the first one has the highest priority. */
  want(wanted: Map<string, Job>): void {
    this.#wanted = wanted;
    for (const [id, running] of this.#running) {
      if (running.isCancelled || wanted.has(running.name)) continue;
      running.isCancelled = true;
      this.settings.cancel(id);
    }
    this.fill();
  }

  /** Requests wanted views up to the limit of concurrent requests. */
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

  /** Records that a view has arrived; returns its job, null if it is unknown. */
  done(id: number): Job | null {
    const found = this.#end(id);
    if (found) {
      this.#failed.delete(found.name);
      this.#wanted.delete(found.name);
      if (this.#told.delete(PASSING)) this.settings.recovered();
    }
    return found?.job ?? null;
  }

  /** Records that a request was cancelled. */
  cancelled(id: number): void {
    this.#end(id);
    this.fill();
  }

  /** Records that a view failed; returns the job if it is not requested again. */
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

  /** Requests all failed views again. */
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
