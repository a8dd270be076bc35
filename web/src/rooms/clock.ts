/** Clock of the browser, replaceable by tests. */

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
