/** Announcements of arriving users for screen readers, combined into one sentence for users who arrive together. */

/** Seconds between the first arrival and the sentence, and between two sentences. */
const [GATHER, PAUSE] = [1, 5] as const;

export interface Arrivals {
  /** Records a user who has arrived, or was present when the connection began. */
  come(number: number, name: string): void;
  left(number: number): void;
  /** Announces arrivals that are due; called often. */
  tell(now: number): void;
  /** Begins a new connection; the next `others` users were present before. */
  begin(others: number): void;
}

export function createArrivals(announce: (sentence: string) => void): Arrivals {
  const untold = new Map<number, string>();
  let known = 0;
  let [since, last]: [number | null, number] = [null, -Infinity];

  return {
    come(number, name) {
      if (known > 0) known -= 1;
      else untold.set(number, name);
    },
    left(number) {
      untold.delete(number);
    },
    tell(now) {
      const [name] = untold.values();
      if (name === undefined) {
        since = null;
        return;
      }
      since ??= now;
      if (now < Math.max(since + GATHER, last + PAUSE)) return;
      announce(untold.size === 1 ? `${name} is here` : `${untold.size} more are here`);
      untold.clear();
      [since, last] = [null, now];
    },
    begin(others) {
      known = others;
      untold.clear();
    },
  };
}
