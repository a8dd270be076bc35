/** Queue of main-thread work in steps that fit into frames. */
import { createCosts, type StepKind } from './costs';
import { createFlight, type Flight } from './flight';

/** Greatest number of bytes that a step sends to the GPU. */
export const STEP_BYTES = 2 ** 18;

/** Step of a job, which takes a fraction of a frame. */
export interface Step {
  readonly kind: StepKind;
  /** Number of bytes that it sends to the GPU. */
  readonly bytes: number;
  readonly run: () => void;
}

export interface Uploads {
  /**
   * Adds the steps of a job; resolves after the last one, rejects when one throws or the job is aborted. Jobs run one
   * after the other; urgent ones first.
   */
  add(steps: Iterable<Step>, signal: AbortSignal, isUrgent?: boolean): Promise<void>;
  /** Records milliseconds of the main thread spent on a decoder's answer, which the next frame's budget lacks. */
  spend(milliseconds: number): void;
  /**
   * Runs the steps that are expected to fit into a budget of milliseconds: at least one, unless answers have used part
   * of it or the GPU lags behind. Returns the milliseconds spent, including answers.
   */
  run(milliseconds: number): number;
  /** Forgets bytes in flight after the graphics were lost. */
  forget(): void;
}

interface Job {
  readonly steps: Iterator<Step>;
  readonly signal: AbortSignal;
  readonly done: () => void;
  readonly failed: (reason: unknown) => void;
  /** Next step, once it is known. */
  next: Step | null;
}

/** Creates the queue; `flight` counts bytes that the GPU has not consumed; by default nothing is counted. */
export function createUploads(now: () => number = () => performance.now(), flight: Flight = createFlight(null)): Uploads {
  const jobs: Job[] = [];
  const costs = createCosts();
  let spent = 0;

  /** Returns the first job with a remaining step, and that step; ends jobs without one. */
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
    // Lets the generator free the results of its steps.
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
