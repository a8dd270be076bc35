/** Looks at something less often than frames are drawn. */

export interface Seldom<Found> {
  /** The thing that was found last or, if that is long ago or was forgotten, what `look` finds. */
  at(now: number, look: () => Found): Found;
  /** The next answer is looked for. */
  forget(): void;
}

/** `every` is the time between two looks, seconds. */
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
