import type { Clock } from '../../src/rooms/clock';

/** Clock that a test advances. */
export interface SteppedClock extends Clock {
  /** Advances by some seconds at once, and then calls the actions that are due. */
  advance(seconds: number): void;
}

export function createSteppedClock(): SteppedClock {
  let time = 100;
  let timers: { readonly due: number; readonly action: () => void }[] = [];
  return {
    now: () => time,
    later(seconds, action) {
      const timer = { due: time + seconds, action };
      timers.push(timer);
      return () => (timers = timers.filter((other) => other !== timer));
    },
    advance(seconds) {
      time += seconds;
      const dueTimers = timers.filter(({ due }) => due <= time + 1e-9);
      timers = timers.filter((timer) => !dueTimers.includes(timer));
      for (const { action } of dueTimers) action();
    },
  };
}
