/** Pose in the fragment of an address, so that a link shows the same view: `#p=x,y,z&yaw=…&pitch=…`. */
import type { Pose } from './pose';
import { bounded, STEEPEST, wrapped } from './vector';

/** Greatest length of a fragment. */
const LONGEST = 512;
/** Greatest coordinate, metres: beyond twice the size of the Earth there is no scene. */
const FARTHEST = 3e7;
const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;

/** Pose in a fragment (with or without `#`), or null. Never throws. */
export function readLink(fragment: string): Pose | null {
  if (fragment.length > LONGEST) return null;
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const [x, y, z, ...rest] = (fields.get('p') ?? '').split(',').map(numberIn);
  if (!isPlace(x) || !isPlace(y) || !isPlace(z) || rest.length > 0) return null;
  const [yaw, pitch] = [numberIn(fields.get('yaw') ?? '0'), numberIn(fields.get('pitch') ?? '0')];
  if (yaw === null || pitch === null) return null;
  return { position: [x, y, z], yaw: wrapped(yaw), pitch: bounded(pitch, -STEEPEST, STEEPEST) };
}

/** Fragment of a pose, precise to a millimetre and 10⁻⁴ radians. */
export function writeLink({ position, yaw, pitch }: Pose): string {
  const place = position.map((value) => rounded(value, 3)).join(',');
  return `#p=${place}&yaw=${rounded(wrapped(yaw), 4)}&pitch=${rounded(pitch, 4)}`;
}

function numberIn(text: string): number | null {
  const value = NUMBER.test(text) ? Number(text) : Number.NaN;
  return Number.isFinite(value) ? value : null;
}

function isPlace(value: number | null | undefined): value is number {
  return value !== null && value !== undefined && Math.abs(value) <= FARTHEST;
}

/** Formats a number without trailing zeros. */
function rounded(value: number, digits: number): string {
  return String(Number(value.toFixed(digits)));
}
