/** Queue of requests for views by priority; cancels unneeded requests, and retries after temporary failures. */
import { canRetry, type Failure } from '../store/error';

/** Least and greatest delay before a failed view is requested again, seconds; the delay doubles each time. */
const [MIN_DELAY, MAX_DELAY] = [1, 30] as const;

/** Key under which all temporary failures are reported once: if the server is unreachable, each view fails. */
const TEMPORARY = '';

export interface QueueSettings<Job> {
  /** Number of concurrent requests. */
  readonly maxRunning: number;
  send(id: number, job: Job): void;
  cancel(id: number): void;
  /** Called once per message when a view fails, but only once for all temporary failures. */
  onFailure(failure: Failure): void;
  /** Called when a view arrives after temporary failures. */
  onRecovered(): void;
  now(): number;
}

interface Running<Job> {
  readonly name: string;
  readonly job: Job;
  isCancelled: boolean;
}

export class Queue<Job> {
  readonly #running = new Map<number, Running<Job>>();
  /** Failed views by name, with the time of their next request. */
  readonly #failed = new Map<string, { readonly retryTime: number; readonly delay: number }>();
  readonly #reported = new Set<string>();
  #requested = new Map<string, Job>();
  #lastId = 0;

  constructor(readonly settings: QueueSettings<Job>) {}

  /** Number of requested views that have not arrived; permanently failed views do not count. */
  get waiting(): number {
    const isRetried = (name: string): boolean => this.#failed.get(name)?.retryTime !== Number.POSITIVE_INFINITY;
    return [...this.#requested.keys()].filter(isRetried).length;
  }

  /** Replaces the requests, which are in the order of their priority. */
  replace(requests: Map<string, Job>): void {
    this.#requested = requests;
    for (const [id, running] of this.#running) {
      if (running.isCancelled || requests.has(running.name)) continue;
      running.isCancelled = true;
      this.settings.cancel(id);
    }
    this.fill();
  }

  /** Sends requests until the limit of concurrent requests is reached. */
  fill(): void {
    const busy = new Set([...this.#running.values()].map(({ name }) => name));
    const now = this.settings.now();
    for (const [name, job] of this.#requested) {
      if (this.#running.size >= this.settings.maxRunning) return;
      if (busy.has(name) || (this.#failed.get(name)?.retryTime ?? 0) > now) continue;
      const id = ++this.#lastId;
      this.#running.set(id, { name, job, isCancelled: false });
      this.settings.send(id, job);
    }
  }

  /** Records that a view has arrived; returns its job, or null if the request is unknown. */
  recordArrival(id: number): Job | null {
    const ended = this.#end(id);
    if (!ended) return null;
    this.#failed.delete(ended.name);
    this.#requested.delete(ended.name);
    if (this.#reported.delete(TEMPORARY)) this.settings.onRecovered();
    return ended.job;
  }

  /** Records that a request was cancelled. */
  recordCancellation(id: number): void {
    this.#end(id);
    this.fill();
  }

  /** Records that a view has failed; returns its job if it is not requested again, else null. */
  recordFailure(id: number, failure: Failure): Job | null {
    const ended = this.#end(id);
    const isTemporary = canRetry(failure);
    if (ended) {
      const delay = Math.min(2 * (this.#failed.get(ended.name)?.delay ?? MIN_DELAY / 2), MAX_DELAY);
      const retryTime = isTemporary ? this.settings.now() + delay : Number.POSITIVE_INFINITY;
      this.#failed.set(ended.name, { retryTime, delay });
      const report = isTemporary ? TEMPORARY : failure.message;
      if (!this.#reported.has(report)) this.settings.onFailure(failure);
      this.#reported.add(report);
    }
    this.fill();
    return isTemporary ? null : (ended?.job ?? null);
  }

  /** Requests all failed views again. */
  retry(): void {
    this.#failed.clear();
    this.#reported.clear();
    this.fill();
  }

  #end(id: number): Running<Job> | null {
    const ended = this.#running.get(id) ?? null;
    this.#running.delete(id);
    return ended;
  }
}
