/** Cache of a value that is computed less often than frames are drawn. */

export interface Seldom<Found> {
  /** Returns the cached value; calls `look` if it is too old or was discarded. */
  at(now: number, look: () => Found): Found;
  /** Discards the cached value. */
  forget(): void;
}

/** Creates the cache; `every` is the interval between two updates, seconds. */
export function createSeldom<Found>(every: number): Seldom<Found> {
  let [found, next]: [{ readonly value: Found } | null, number] = [null, 0];
  return {
    at(now, look) {
      if (!found || now >= next) {
        found = { value: look() };
        next = now + every;
      }
      return found.value;
    },
    forget() {
      found = null;
    },
  };
}
