/** Round trips by the paper's Eq. 3: from the sending of a pose until all others of the group have acknowledged it. */

/** Seconds between two poses to be acknowledged; greatest number of open ones. */
const [EVERY, MAX_OPEN] = [0.25, 64] as const;
/** Number of round trips for the median. */
const KEPT = 32;

export interface RoundTrips {
  /** Median of the last round trips, seconds; null before the first. */
  readonly median: number | null;
  /**
   * Records a pose that is about to be sent; returns whether it is to be acknowledged. The last pose before a pause is
   * if another one is open, because that one may be lost and would be settled only after the pause.
   */
  send(sequence: number, now: number, isLast: boolean): boolean;
  /** Records that all others have acknowledged this pose or a later one. */
  settle(sequence: number, now: number): void;
  /** Discards open round trips, because the connection is a new one. */
  forget(): void;
}

export function createRoundTrips(): RoundTrips {
  const open = new Map<number, number>();
  let last = -Infinity;
  let kept: number[] = [];

  return {
    get median() {
      const sorted = [...kept].sort((a, b) => a - b);
      return sorted[sorted.length >> 1] ?? null;
    },
    send(sequence, now, isLast) {
      if (now - last < EVERY && !(isLast && open.size > 0)) return false;
      last = now;
      const [oldest] = open.keys();
      if (open.size >= MAX_OPEN && oldest !== undefined) open.delete(oldest);
      open.set(sequence, now);
      return true;
    },
    settle(sequence, now) {
      for (const [sent, time] of open) {
        if (sent > sequence) continue;
        open.delete(sent);
        kept = [...kept, now - time].slice(-KEPT);
      }
    },
    forget() {
      open.clear();
      last = -Infinity;
    },
  };
}
