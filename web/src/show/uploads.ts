/** Work that must happen on the main thread, in steps that fit into frames. */

/** Each step takes a fraction of a frame. */
export type Step = () => void;

export interface Uploads {
  /** Add steps of one job; resolves when the last one is done, rejects when one throws or the job is dropped. */
  add(steps: Iterable<Step>, signal: AbortSignal): Promise<void>;
  /** Do steps until so many milliseconds have passed, at least one if there is any; returns the milliseconds taken. */
  run(milliseconds: number): number;
}

interface Job {
  readonly steps: Iterator<Step>;
  readonly signal: AbortSignal;
  readonly done: () => void;
  readonly failed: (reason: unknown) => void;
}

export function createUploads(now: () => number = () => performance.now()): Uploads {
  const jobs: Job[] = [];

  /** One step of the first job; false if nothing is left to do. */
  function step(): boolean {
    const job = jobs[0];
    if (!job) return false;
    try {
      job.signal.throwIfAborted();
      const next = job.steps.next();
      if (!next.done) {
        next.value();
        return true;
      }
      job.done();
    } catch (error) {
      // Meshes that the steps have made until now are of no use.
      job.steps.return?.();
      job.failed(error);
    }
    jobs.shift();
    return true;
  }

  return {
    add(steps, signal) {
      return new Promise((done, failed) => {
        jobs.push({ steps: steps[Symbol.iterator](), signal, done, failed });
      });
    },
    run(milliseconds) {
      const start = now();
      while (step() && now() - start < milliseconds);
      return now() - start;
    },
  };
}
