/** Powers of the ratio of two consecutive codes' ranges, bit-identical on every machine. */
import { NOTHING } from './planes';

/** Codes around a guess that are tried before all others. */
const NEARBY = 4;

export interface Scale {
  /** Inverse range, scaled to be linear over the texels of a plane: the texel's distance at depth 1 over its range. */
  nearness(code: number, distance: number): number;
  /** Code of a nearness; the guess only saves time. */
  code(nearness: number, distance: number, guess: number): number;
}

export function createScale(step: number): Scale {
  const [ratio, half] = [exponential(step), exponential(0.5 * step)];
  const reciprocals = new Float64Array(NOTHING);
  const ends = new Float64Array(NOTHING - 1);
  for (let code = 0, power = 1; code < NOTHING; code++, power *= ratio) {
    reciprocals[code] = 1 / power;
    if (code < ends.length) ends[code] = power * half;
  }
  const last = ends.length;
  return {
    nearness: (code, distance) => distance * (reciprocals[code] as number),
    code(nearness, distance, guess) {
      if (!(nearness > 0)) return NOTHING - 1;
      const range = distance / nearness;
      let from = Math.max(guess - NEARBY, 0);
      let to = guess + NEARBY;
      const isWithin =
        to < last && (from === 0 || (ends[from - 1] as number) <= range) && range < (ends[to] as number);
      if (!isWithin) [from, to] = [0, last];
      // Binary search for the number of bounds up to the range.
      while (from < to) {
        const middle = (from + to) >> 1;
        if ((ends[middle] as number) <= range) from = middle + 1;
        else to = middle;
      }
      return from;
    },
  };
}

/** exp(x) for small x by its series, because libraries differ in the last digit. */
function exponential(x: number): number {
  let sum = 1;
  for (let n = 10; n >= 1; n--) sum = 1 + (x / n) * sum;
  return sum;
}
