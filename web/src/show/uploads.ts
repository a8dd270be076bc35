/** Queue of main-thread work in steps that fit into frames, and into the memory that browsers have for uploads. */

/** Greatest number of bytes that a step sends to the GPU. */
export const STEP_BYTES = 2 ** 18;

/** Step of a job, which takes a fraction of a frame. */
export interface Step {
  readonly kind: StepKind;
  /** Number of bytes that it sends to the GPU. */
  readonly bytes: number;
  readonly run: () => void;
}

export type Uploads = ReturnType<typeof createUploads>;

interface Job {
  readonly steps: Iterator<Step>;
  readonly signal: AbortSignal;
  readonly done: () => void;
  readonly failed: (reason: unknown) => void;
  /** Next step, once it is known. */
  next: Step | null;
}

/** Creates the queue; `flight` counts bytes that the GPU has not consumed; by default nothing is counted. */
export function createUploads(now: () => number = () => performance.now(), flight = createFlight(null)) {
  const jobs: Job[] = [];
  const costs = createCosts();
  let spent = 0;

  /** Returns the first job with a remaining step, and that step; ends jobs without one. */
  function next(): { job: Job; step: Step } | null {
    for (let job = jobs[0]; job; job = jobs[0]) {
      try {
        job.signal.throwIfAborted();
        job.next ??= (job.steps.next().value as Step | undefined) ?? null;
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
    /**
     * Adds the steps of a job; resolves after the last one, rejects when one throws or the job is aborted. Jobs run one
     * after the other; urgent ones first.
     */
    add(steps: Iterable<Step>, signal: AbortSignal, isUrgent = false): Promise<void> {
      return new Promise((done, failed) => {
        const job: Job = { steps: steps[Symbol.iterator](), signal, done, failed, next: null };
        if (isUrgent) jobs.unshift(job);
        else jobs.push(job);
      });
    },
    /** Records milliseconds of the main thread spent on a decoder's answer; they reduce the next frame's budget. */
    spend(milliseconds: number): void {
      spent += milliseconds;
    },
    /**
     * Runs the steps that are expected to fit into a budget of milliseconds: at least one, unless answers have used
     * part of it or the GPU lags behind. Returns the milliseconds spent, including answers.
     */
    run(milliseconds: number): number {
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
    /** Forgets bytes in flight after the graphics were lost. */
    forget: flight.forget,
  };
}

/** Kind of a step; its duration is a constant plus a term proportional to its bytes. */
export type StepKind = 'map' | 'picture' | 'arrays' | 'mesh' | 'program';

/** Number of bytes whose upload takes as long as an empty step. */
const UNIT_BYTES = 2 ** 16;
/** Initial milliseconds per unit: those of a slow computer. */
const INITIAL_MS: Readonly<Record<StepKind, number>> = { map: 0.2, picture: 0.2, arrays: 0.1, mesh: 0.5, program: 2.5 };
const LEARNING_RATE = 0.15;
/** Greatest ratio to the estimate that is learned: longer steps were interrupted. */
const MAX_RATIO = 4;

/** Predicts the duration of steps from earlier ones of the same kind. */
function createCosts() {
  const learnedCosts = new Map<StepKind, number>();
  const unit = (kind: StepKind): number => learnedCosts.get(kind) ?? INITIAL_MS[kind];
  const units = (bytes: number): number => 1 + bytes / UNIT_BYTES;
  return {
    /** Expected duration of a step, milliseconds. */
    expected: ({ kind, bytes }: Step): number => unit(kind) * units(bytes),
    learn({ kind, bytes }: Step, milliseconds: number): void {
      const before = unit(kind);
      const measured = Math.min(milliseconds / units(bytes), MAX_RATIO * before);
      learnedCosts.set(kind, before + LEARNING_RATE * (measured - before));
    },
  };
}

/** Greatest number of bytes in flight; Chromium blocks from 16 MiB on. */
export const MAX_IN_FLIGHT = 2 ** 23;

/**
 * Counter of bytes that were sent to the GPU and not consumed. Browsers have little memory for them: once it is full,
 * a call blocks until the GPU has finished all before it, which can take many frames with software rendering.
 */
export type Flight = ReturnType<typeof createFlight>;

/** Creates the counter; `gl` is null if nothing needs to be counted. */
export function createFlight(gl: WebGL2RenderingContext | null) {
  let marks: { readonly sync: WebGLSync; readonly bytes: number }[] = [];
  let sent = 0;

  /** Removes fences that the GPU has passed. */
  function settle(context: WebGL2RenderingContext): void {
    for (let first = marks[0]; first; first = marks[0]) {
      if (context.getSyncParameter(first.sync, context.SYNC_STATUS) !== context.SIGNALED) return;
      context.deleteSync(first.sync);
      marks.shift();
    }
  }

  return {
    send(bytes: number): void {
      sent += bytes;
    },
    /** Whether this many more bytes may be sent. */
    hasRoom(bytes: number): boolean {
      if (!gl || bytes === 0) return true;
      settle(gl);
      const bytesInFlight = marks.reduce((sum, mark) => sum + mark.bytes, sent);
      // An idle GPU takes any amount.
      return bytesInFlight === 0 || bytesInFlight + bytes <= MAX_IN_FLIGHT;
    },
    /** Inserts a fence: bytes sent before it count as consumed when the GPU passes it. */
    mark(): void {
      if (gl && sent > 0) {
        const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        if (sync) marks.push({ sync, bytes: sent });
        gl.flush();
      }
      sent = 0;
    },
    /** Resets the counter after the graphics were lost. */
    forget(): void {
      [marks, sent] = [[], 0];
    },
  };
}
