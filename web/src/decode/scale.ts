/** Powers of the ratio of two consecutive codes' ranges, with the same digits on every machine. */
import { NOTHING } from './planes';

/** Codes around a guess that are tried before all of them. */
const NEARBY = 4;

export interface Scale {
  /** A value that is linear over the texels of a plane: the distance of the texel at depth 1 over its range. */
  nearness(code: number, distance: number): number;
  /** The code of a nearness; the guess saves time only. */
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
      // The number of ends that are not above the range.
      while (from < to) {
        const middle = (from + to) >> 1;
        if ((ends[middle] as number) <= range) from = middle + 1;
        else to = middle;
      }
      return from;
    },
  };
}

/** exp(x) of small x by its series: functions of mathematical libraries differ in the last digit. */
function exponential(x: number): number {
  let sum = 1;
  for (let n = 10; n >= 1; n--) sum = 1 + (x / n) * sum;
  return sum;
}
