/** The browser's clock, so that tests may have one of their own. */

export interface Clock {
  /** Seconds from any begin. */
  now(): number;
  /** Act after some seconds; the answer is a function that prevents it. */
  later(seconds: number, action: () => void): () => void;
}

export const CLOCK: Clock = {
  now: () => performance.now() / 1000,
  later(seconds, action) {
    const timer = setTimeout(action, 1000 * seconds);
    return () => clearTimeout(timer);
  },
};
