/** Formats numbers for the panel. Invalid numbers become a dash. */

const UNKNOWN = '–';
const NO_BREAK_SPACE = '\u00a0';
const PREFIXES = ['', 'k', 'M', 'G', 'T'] as const;

/** `12.4 MB`. */
export function bytes(count: number): string {
  return withPrefix(count, 'B');
}

/** `12.4 of 45.1 MB`: both in the unit of the larger one. */
export function bytesOf(part: number, whole: number): string {
  if (!isAmount(part) || !isAmount(whole)) return UNKNOWN;
  const power = powerOf(Math.max(part, whole));
  return `${digits(part, power)} of ${digits(whole, power)}${NO_BREAK_SPACE}${PREFIXES[power]}B`;
}

/** Bits per second, `48.2 Mb/s`; `idle` for null. */
export function rate(bits: number | null): string {
  return bits === null ? 'idle' : withPrefix(bits, 'b/s');
}

/** `640,886`, from a million on `1.24 million`. */
export function count(number: number): string {
  if (!isAmount(number)) return UNKNOWN;
  if (number >= 999.5e6) return `${(number / 1e9).toFixed(2)}${NO_BREAK_SPACE}billion`;
  if (number >= 999_999.5) return `${(number / 1e6).toFixed(2)}${NO_BREAK_SPACE}million`;
  return Math.round(number).toLocaleString('en');
}

/** `19 %`; 100 % only for the whole, and 0 % only for nothing. */
export function percent(part: number, whole: number): string {
  if (!isAmount(part) || !isAmount(whole)) return UNKNOWN;
  const share = whole > 0 ? (100 * part) / whole : 100;
  if (share > 0 && share < 1) return `<${NO_BREAK_SPACE}1${NO_BREAK_SPACE}%`;
  return `${Math.min(Math.floor(share), 100)}${NO_BREAK_SPACE}%`;
}

/** `11.2 ms`, from 100 ms on `125 ms`. */
export function milliseconds(time: number): string {
  return isAmount(time) ? `${time.toFixed(time < 99.95 ? 1 : 0)}${NO_BREAK_SPACE}ms` : UNKNOWN;
}

/** `0.35 m`, `22.0 m`, `140 m`, `3.2 km`. */
export function metres(length: number): string {
  if (!isAmount(length)) return UNKNOWN;
  if (length >= 999.5) return `${(length / 1000).toFixed(1)}${NO_BREAK_SPACE}km`;
  return `${length.toFixed(length < 0.995 ? 2 : length < 99.95 ? 1 : 0)}${NO_BREAK_SPACE}m`;
}

function withPrefix(amount: number, unit: string): string {
  if (!isAmount(amount)) return UNKNOWN;
  const power = powerOf(amount);
  return `${digits(amount, power)}${NO_BREAK_SPACE}${PREFIXES[power]}${unit}`;
}

/** Returns the number of the prefix with which an amount has at most three digits before the point. */
function powerOf(amount: number): number {
  let power = 0;
  while (power < PREFIXES.length - 1 && amount / 1000 ** power >= 999.5) power += 1;
  return power;
}

function digits(amount: number, power: number): string {
  const value = amount / 1000 ** power;
  return value.toFixed(power > 1 && value < 99.95 ? 1 : 0);
}

function isAmount(number: number): boolean {
  return Number.isFinite(number) && number >= 0;
}
