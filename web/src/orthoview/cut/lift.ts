/** Raising of viewers' directions towards the zenith. */
import type { Triple } from '../store/layout';

/** Sine of the angle from straight down within which a direction cannot be raised to a side. */
const STRAIGHT = 1e-9;

/** Function that rotates unit vectors by an angle in degrees towards +y, at most to +y. Straight down stays. */
export function liftOf(degrees: number): (way: Triple) => Triple {
  const angle = (degrees * Math.PI) / 180;
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return (way) => {
    const [x, y, z] = way;
    const flat = Math.hypot(x, z);
    if (sine === 0 || (flat < STRAIGHT && y < 0)) return way;
    const across = flat * cosine - y * sine;
    if (across <= 0) return [0, 1, 0];
    return [(x / flat) * across, y * cosine + flat * sine, (z / flat) * across];
  };
}
