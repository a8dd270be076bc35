/** A rate with what may come at once. */
import type { Clock } from '../rooms/clock';

export interface Bucket {
  /** Take an amount; false if there is not as much. */
  take(amount: number): boolean;
  /** Seconds until there is an amount, of at most what may come at once. */
  secondsTo(amount: number): number;
}

/** So much a second, of which `most` may come at once. */
export function createBucket(rate: number, most: number, now: Clock['now']): Bucket {
  let [level, since] = [most, now()];

  function fill(): void {
    const time = now();
    level = Math.min(level + rate * Math.max(time - since, 0), most);
    since = time;
  }

  return {
    take(amount) {
      fill();
      if (level < amount) return false;
      level -= amount;
      return true;
    },
    secondsTo(amount) {
      fill();
      return Math.max(Math.min(amount, most) - level, 0) / rate;
    },
  };
}
