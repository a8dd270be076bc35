/** Clock of the browser, replaceable by tests, and a rate limit that runs on it. */

export interface Clock {
  /** Seconds since an arbitrary origin. */
  now(): number;
  /** Calls an action after some seconds; returns a function that cancels it. */
  later(seconds: number, action: () => void): () => void;
}

export const CLOCK: Clock = {
  now: () => performance.now() / 1000,
  later(seconds, action) {
    const timer = setTimeout(action, 1000 * seconds);
    return () => clearTimeout(timer);
  },
};

/** Token bucket: a rate with a burst. */
export type Bucket = ReturnType<typeof createBucket>;

/** Creates a bucket of `rate` units per second with a burst of `burst` units. */
export function createBucket(rate: number, burst: number, now: Clock['now']) {
  let [level, since] = [burst, now()];

  function fill(): void {
    const time = now();
    level = Math.min(level + rate * Math.max(time - since, 0), burst);
    since = time;
  }

  return {
    /** Takes an amount; returns false if less is available. */
    take(amount: number): boolean {
      fill();
      if (level < amount) return false;
      level -= amount;
      return true;
    },
    /** Seconds until an amount is available, which is at most the burst. */
    secondsTo(amount: number): number {
      fill();
      return Math.max(Math.min(amount, burst) - level, 0) / rate;
    },
  };
}
