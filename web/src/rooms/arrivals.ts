/** Says who has come, for readers of screens: one sentence for all who come together, so that many are not many sentences. */

/** Seconds from the first one to the sentence, and between two sentences. */
const [GATHER, PAUSE] = [1, 5] as const;

export interface Arrivals {
  /** A user has come, or is there already when one's own connection begins. */
  come(number: number, name: string): void;
  left(number: number): void;
  /** Call it often; says what is to be said. */
  tell(now: number): void;
  /** The connection is another one: so many others who come next were there before. */
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
