/** Measures loading and drawing for the panel, and marks the progress of loading on the browser's timeline. */

/** Seconds over which the rate and the frame times are measured. */
const WINDOW_SECONDS = 1;

export function createMeter(now: () => number = () => performance.now() / 1000) {
  let received = 0;
  let arrivals: { time: number; bytes: number }[] = [];
  let frames: number[] = [];
  return {
    /** Adds received bytes. */
    receive(bytes: number): void {
      received += bytes;
      arrivals.push({ time: now(), bytes });
    },
    /** Adds the duration of a frame, seconds. */
    frame(seconds: number): void {
      frames.push(seconds);
      let sum = frames.reduce((total, duration) => total + duration, 0);
      while (frames.length > 1 && sum > WINDOW_SECONDS) sum -= frames.shift() ?? 0;
    },
    /** Resets all measurements. */
    reset(): void {
      [received, arrivals, frames] = [0, [], []];
    },
    /** Returns the bytes received, bits per second (null if none arrive), and mean and greatest frame time in ms. */
    read() {
      const windowStart = now() - WINDOW_SECONDS;
      arrivals = arrivals.filter(({ time }) => time > windowStart);
      const bytes = arrivals.reduce((sum, arrival) => sum + arrival.bytes, 0);
      const mean = frames.reduce((sum, duration) => sum + duration, 0) / Math.max(frames.length, 1);
      return {
        received,
        rate: bytes > 0 ? (8 * bytes) / WINDOW_SECONDS : null,
        frame: 1000 * mean,
        maxFrame: 1000 * Math.max(0, ...frames),
      };
    },
  };
}

/** Marks the time at which a ring of a region can be shown (`arrived`), or is in the picture (`shown`). */
export function markTimeline(event: 'arrived' | 'shown', region: number, ring: number): void {
  performance.mark(`nearfar:${event}`, { detail: { region, ring } });
}
