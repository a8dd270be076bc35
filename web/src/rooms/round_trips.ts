/** Round trips by the paper's Eq. 3: from the sending of a pose until all others of the group have acknowledged it. */

/** Seconds between two poses that are to be acknowledged, and poses that wait for it at most. */
const [EVERY, MOST_OPEN] = [0.25, 64] as const;
/** Round trips of which the median is told. */
const KEPT = 32;

export interface RoundTrips {
  /** Seconds, the median of the last ones; null before the first. */
  readonly median: number | null;
  /**
   * A pose is about to be sent; whether it is to be acknowledged. The last one before a pause is, if another is open: that
   * one may have got lost, and would be settled after the pause alone.
   */
  send(sequence: number, now: number, isLast: boolean): boolean;
  /** All others have acknowledged this pose, or a later one. */
  settle(sequence: number, now: number): void;
  /** The connection is another one. */
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
      if (open.size >= MOST_OPEN && oldest !== undefined) open.delete(oldest);
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
