/** Queue of work on the main thread, in steps that fit into frames and into the memory of browsers for uploads. */

/** Greatest number of bytes that one step sends to the GPU. */
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
  readonly onEnd: () => void;
  readonly onFailure: (reason: unknown) => void;
  /** Next step; null before it is read from `steps`. */
  next: Step | null;
}

/** Creates the queue; `flight` counts the bytes that the GPU has not consumed, by default none. */
export function createUploads(now: () => number = () => performance.now(), flight = createFlight(null)) {
  const jobs: Job[] = [];
  const costs = createCosts();
  let spent = 0;

  /** Returns the next step and its job; ends jobs whose steps have all run. */
  function findStep(): { job: Job; step: Step } | null {
    for (let job = jobs[0]; job; job = jobs[0]) {
      try {
        job.signal.throwIfAborted();
        job.next ??= (job.steps.next().value as Step | undefined) ?? null;
        if (job.next) return { job, step: job.next };
        end(job);
        job.onEnd();
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
    // The generator frees what its steps have prepared.
    job.steps.return?.();
    job.onFailure(error);
  }

  function runStep({ job, step }: { job: Job; step: Step }): void {
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
     * Adds a job; resolves after its last step, rejects when a step throws or the job is aborted. Jobs run one after
     * the other, urgent ones first.
     */
    add(steps: Iterable<Step>, signal: AbortSignal, isUrgent = false): Promise<void> {
      return new Promise((onEnd, onFailure) => {
        const job: Job = { steps: steps[Symbol.iterator](), signal, onEnd, onFailure, next: null };
        if (isUrgent) jobs.unshift(job);
        else jobs.push(job);
      });
    },
    /** Records milliseconds that the main thread has spent on a decoder's answer; the next frame has so much less. */
    spend(milliseconds: number): void {
      spent += milliseconds;
    },
    /**
     * Runs as many steps as should fit into a budget of milliseconds. At least one runs, unless answers have used part
     * of the budget or the GPU lags behind. Returns the milliseconds spent, with those for answers.
     */
    run(milliseconds: number): number {
      const start = now() - spent;
      let isIdle = spent === 0;
      spent = 0;
      for (let found = findStep(); found; found = findStep()) {
        const { step } = found;
        const isLate = now() - start + costs.estimate(step) > milliseconds;
        if ((isLate && !isIdle) || !flight.hasRoom(step.bytes)) break;
        runStep(found);
        isIdle = false;
      }
      flight.mark();
      return now() - start;
    },
    /** Forgets the bytes in flight, after the graphics context was lost. */
    forget: flight.forget,
  };
}

/** Kind of a step. Steps of a kind take a constant time plus a time in proportion to their bytes. */
export type StepKind = 'map' | 'picture' | 'arrays' | 'mesh' | 'program';

/** Number of bytes whose upload takes as long as an empty step. */
const UNIT_BYTES = 2 ** 16;
/** Initial milliseconds per unit: those of a slow computer. */
const INITIAL_MS: Readonly<Record<StepKind, number>> = { map: 0.2, picture: 0.2, arrays: 0.1, mesh: 0.5, program: 2.5 };
const LEARNING_RATE = 0.15;
/** Longest duration that is learned, as a multiple of the estimate: longer steps were probably interrupted. */
const MAX_RATIO = 4;

/** Estimates the duration of steps from earlier steps of the same kind. */
function createCosts() {
  const learnedCosts = new Map<StepKind, number>();
  const unit = (kind: StepKind): number => learnedCosts.get(kind) ?? INITIAL_MS[kind];
  const units = (bytes: number): number => 1 + bytes / UNIT_BYTES;
  return {
    /** Returns the estimated duration of a step, milliseconds. */
    estimate: ({ kind, bytes }: Step): number => unit(kind) * units(bytes),
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
 * Counter of the bytes that were sent to the GPU and that it has not consumed. Browsers have little memory for them:
 * once it is full, a call waits until the GPU has done all earlier work, which can take many frames in software.
 */
export type Flight = ReturnType<typeof createFlight>;

/** Creates the counter; `gl` is null if nothing needs to be counted. */
export function createFlight(gl: WebGL2RenderingContext | null) {
  let marks: { readonly sync: WebGLSync; readonly bytes: number }[] = [];
  let sent = 0;

  /** Removes the fences that the GPU has passed. */
  function removePassed(context: WebGL2RenderingContext): void {
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
    /** Whether so many more bytes may be sent. */
    hasRoom(bytes: number): boolean {
      if (!gl || bytes === 0) return true;
      removePassed(gl);
      const bytesInFlight = marks.reduce((sum, mark) => sum + mark.bytes, sent);
      // If nothing is in flight, any number of bytes may be sent.
      return bytesInFlight === 0 || bytesInFlight + bytes <= MAX_IN_FLIGHT;
    },
    /** Inserts a fence; the bytes sent before it count as consumed when the GPU passes it. */
    mark(): void {
      if (gl && sent > 0) {
        const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        if (sync) marks.push({ sync, bytes: sent });
        gl.flush();
      }
      sent = 0;
    },
    /** Resets the counter, after the graphics context was lost. */
    forget(): void {
      [marks, sent] = [[], 0];
    },
  };
}
