/** Measures what the panel shows: bytes, their rate, and times of frames. */

/** Seconds that a rate and a time of frames are taken over. */
const WINDOW = 1;

export interface Meter {
  /** So many bytes have come. */
  receive(bytes: number): void;
  /** A frame has taken so many seconds. */
  frame(seconds: number): void;
  /** Count from 0. */
  restart(): void;
  /** Bytes; bits a second, null while nothing comes; milliseconds of frames, their mean and the longest. */
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
