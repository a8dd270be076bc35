/** Pose of the user's head, its directions, and the link that leads back to it. */

/** Position and direction of the user's head in the world: metres, y up, radians. */
export interface Pose {
  readonly position: readonly [number, number, number];
  /** Turn about the vertical axis; 0 looks along −z, positive to the left. */
  readonly yaw: number;
  /** Positive looks up. */
  readonly pitch: number;
}

export type Vector = readonly [number, number, number];

/** Greatest pitch, radians, because straight up has no yaw. */
export const MAX_PITCH = 1.5;

export function clamp(value: number, least: number, greatest: number): number {
  return Math.min(Math.max(value, least), greatest);
}

/** Wraps an angle to [−π, π]. */
export function wrapAngle(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/** Unit vector in the direction of view. */
export function ahead({ yaw, pitch }: Pick<Pose, 'yaw' | 'pitch'>): Vector {
  return [-Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), -Math.cos(yaw) * Math.cos(pitch)];
}

/** Horizontal unit vector to the right. */
export function rightOf(yaw: number): Vector {
  return [Math.cos(yaw), 0, -Math.sin(yaw)];
}

/** Unit vector that points up in the picture. */
export function upOf({ yaw, pitch }: Pick<Pose, 'yaw' | 'pitch'>): Vector {
  return [Math.sin(yaw) * Math.sin(pitch), Math.cos(pitch), Math.cos(yaw) * Math.sin(pitch)];
}

/** a + factor · b. */
export function addScaled(a: Vector, b: Vector, factor: number): Vector {
  return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
}

export function subtract(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

/** Vector of length 1 in the same direction; the zero vector stays. */
export function unit([x, y, z]: Vector): Vector {
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}

export function isSamePose(a: Pose, b: Pose): boolean {
  return a.yaw === b.yaw && a.pitch === b.pitch && a.position.every((value, axis) => value === b.position[axis]);
}

const MAX_FRAGMENT_LENGTH = 512;
/** Greatest coordinate, metres: more than twice the diameter of the Earth. */
const MAX_COORDINATE = 3e7;
const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;

/** Parses the pose in a fragment, with or without `#`; null if it is invalid. */
export function readLink(fragment: string): Pose | null {
  if (fragment.length > MAX_FRAGMENT_LENGTH) return null;
  const fields = new URLSearchParams(fragment.replace(/^#/, ''));
  const [x, y, z, ...rest] = (fields.get('p') ?? '').split(',').map(parseNumber);
  if (!isPlace(x) || !isPlace(y) || !isPlace(z) || rest.length > 0) return null;
  const [yaw, pitch] = [parseNumber(fields.get('yaw') ?? '0'), parseNumber(fields.get('pitch') ?? '0')];
  if (yaw === null || pitch === null) return null;
  return { position: [x, y, z], yaw: wrapAngle(yaw), pitch: clamp(pitch, -MAX_PITCH, MAX_PITCH) };
}

/** Writes a pose as a fragment, precise to a millimetre and 10⁻⁴ radians. */
export function writeLink({ position, yaw, pitch }: Pose): string {
  const place = position.map((value) => formatNumber(value, 3)).join(',');
  return `#p=${place}&yaw=${formatNumber(wrapAngle(yaw), 4)}&pitch=${formatNumber(pitch, 4)}`;
}

function parseNumber(text: string): number | null {
  const value = NUMBER.test(text) ? Number(text) : Number.NaN;
  return Number.isFinite(value) ? value : null;
}

function isPlace(value: number | null | undefined): value is number {
  return value !== null && value !== undefined && Math.abs(value) <= MAX_COORDINATE;
}

/** Formats a number without trailing zeros. */
function formatNumber(value: number, digits: number): string {
  return String(Number(value.toFixed(digits)));
}
