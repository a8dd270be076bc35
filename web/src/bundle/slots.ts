/** Runs a limited number of jobs at once, and queues the others in order. */

export type Slots = <T>(signal: AbortSignal, job: () => Promise<T>) => Promise<T>;

export function createSlots(number: number): Slots {
  let free = number;
  const waiting = new Set<() => void>();

  function place(signal: AbortSignal): Promise<void> {
    return new Promise((done, failed) => {
      const leave = (): void => {
        waiting.delete(enter);
        failed(signal.reason as Error);
      };
      const enter = (): void => {
        signal.removeEventListener('abort', leave);
        done();
      };
      waiting.add(enter);
      signal.addEventListener('abort', leave, { once: true });
    });
  }

  return async (signal, job) => {
    signal.throwIfAborted();
    if (free === 0) await place(signal);
    else free -= 1;
    try {
      return await job();
    } finally {
      const [next] = waiting;
      if (next) {
        waiting.delete(next);
        next();
      } else {
        free += 1;
      }
    }
  };
}
