/** Measurements for the panel, and marks of the loading on the browser's timeline. */

/** Window in seconds of the rate and the frame times. */
const WINDOW = 1;

export interface Meter {
  /** Adds received bytes. */
  receive(bytes: number): void;
  /** Adds the duration of a frame, seconds. */
  frame(seconds: number): void;
  /** Resets all measurements. */
  restart(): void;
  /** Received bytes; bits per second, null while nothing arrives; mean and greatest frame time in milliseconds. */
  read(): { received: number; rate: number | null; frame: number; longest: number };
}

export function createMeter(now: () => number = () => performance.now() / 1000): Meter {
  let received = 0;
  let arrivals: { time: number; bytes: number }[] = [];
  let frames: number[] = [];
  return {
    receive(bytes) {
      received += bytes;
      arrivals.push({ time: now(), bytes });
    },
    frame(seconds) {
      frames.push(seconds);
      let sum = frames.reduce((total, each) => total + each, 0);
      while (frames.length > 1 && sum > WINDOW) sum -= frames.shift() ?? 0;
    },
    restart() {
      received = 0;
      arrivals = [];
      frames = [];
    },
    read() {
      const since = now() - WINDOW;
      arrivals = arrivals.filter(({ time }) => time > since);
      const bytes = arrivals.reduce((sum, arrival) => sum + arrival.bytes, 0);
      const mean = frames.reduce((sum, each) => sum + each, 0) / Math.max(frames.length, 1);
      return {
        received,
        rate: bytes > 0 ? (8 * bytes) / WINDOW : null,
        frame: 1000 * mean,
        longest: 1000 * Math.max(0, ...frames),
      };
    },
  };
}

/** Marks that a ring of a region can be shown, or is in the current frame. */
export function markTimeline(event: 'arrived' | 'shown', region: number, ring: number): void {
  performance.mark(`nearfar:${event}`, { detail: { region, ring } });
}
