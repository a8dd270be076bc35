/** Work that must happen on the main thread, in steps that fit into frames. */
import { createCosts, type StepKind } from './costs';
import { createFlight, type Flight } from './flight';

/** Bytes that a step sends to the GPU, at most. */
export const STEP_BYTES = 2 ** 18;

/** Each step takes a fraction of a frame. */
export interface Step {
  readonly kind: StepKind;
  /** Bytes that it sends to the GPU. */
  readonly bytes: number;
  readonly run: () => void;
}

export interface Uploads {
  /**
   * Add steps of one job; resolves when the last one is done, rejects when one throws or the job is dropped. Jobs are
   * done one after the other; an urgent one before all others.
   */
  add(steps: Iterable<Step>, signal: AbortSignal, isUrgent?: boolean): Promise<void>;
  /** So many milliseconds of the main thread were taken for a decoder's answer: the next frame has as much less. */
  spend(milliseconds: number): void;
  /**
   * Do the steps that fit into so many milliseconds, as far as can be foreseen: one at least, unless answers have taken
   * a part of them or the GPU lags behind. Returns the milliseconds taken, with those of answers.
   */
  run(milliseconds: number): number;
  /** The graphics were lost, and with them what was on its way. */
  forget(): void;
}

interface Job {
  readonly steps: Iterator<Step>;
  readonly signal: AbortSignal;
  readonly done: () => void;
  readonly failed: (reason: unknown) => void;
  /** The step that comes next, once it is asked for. */
  next: Step | null;
}

/** `flight` knows what the GPU has not taken yet; without one it takes all at once. */
export function createUploads(now: () => number = () => performance.now(), flight: Flight = createFlight(null)): Uploads {
  const jobs: Job[] = [];
  const costs = createCosts();
  let spent = 0;

  /** The first job that has a step left, and that step; jobs without one end. */
  function next(): { job: Job; step: Step } | null {
    for (let job = jobs[0]; job; job = jobs[0]) {
      try {
        job.signal.throwIfAborted();
        job.next ??= following(job);
        if (job.next) return { job, step: job.next };
        end(job);
        job.done();
      } catch (error) {
        fail(job, error);
      }
    }
    return null;
  }

  function end(job: Job): void {
    jobs.splice(jobs.indexOf(job), 1);
  }

  function fail(job: Job, error: unknown): void {
    end(job);
    // Results of its steps until now are of no use.
    job.steps.return?.();
    job.failed(error);
  }

  function take({ job, step }: { job: Job; step: Step }): void {
    const start = now();
    job.next = null;
    flight.send(step.bytes);
    try {
      step.run();
    } catch (error) {
      fail(job, error);
    }
    costs.learn(step, now() - start);
  }

  return {
    add(steps, signal, isUrgent = false) {
      return new Promise((done, failed) => {
        const job: Job = { steps: steps[Symbol.iterator](), signal, done, failed, next: null };
        if (isUrgent) jobs.unshift(job);
        else jobs.push(job);
      });
    },
    spend(milliseconds) {
      spent += milliseconds;
    },
    run(milliseconds) {
      const start = now() - spent;
      let isIdle = spent === 0;
      spent = 0;
      for (let found = next(); found; found = next()) {
        const { step } = found;
        const isLate = now() - start + costs.expected(step) > milliseconds;
        if ((isLate && !isIdle) || !flight.hasRoom(step.bytes)) break;
        take(found);
        isIdle = false;
      }
      flight.mark();
      return now() - start;
    },
    forget: flight.forget,
  };
}

function following(job: Job): Step | null {
  const { done, value } = job.steps.next() as IteratorResult<Step, undefined>;
  return done ? null : value;
}
