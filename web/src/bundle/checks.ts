/** Checks of parsed JSON: each returns the value, or throws an error that names its place. */
import { BundleError } from './error';

export type Fields = Readonly<Record<string, unknown>>;

function errorAt(place: string, expected: string, got: unknown): BundleError {
  const text = JSON.stringify(got) ?? 'nothing';
  return new BundleError(`manifest.json: ${place}: expected ${expected}, got ${text.slice(0, 60)}`);
}

export function object(place: string, value: unknown): Fields {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw errorAt(place, 'an object', value);
  return value as Fields;
}

export function number(place: string, value: unknown, least: number, greatest = Number.MAX_VALUE): number {
  const isWithin = typeof value === 'number' && value >= least && value <= greatest;
  if (!isWithin) throw errorAt(place, `a number of at least ${least}`, value);
  return value;
}

export function integer(place: string, value: unknown, least: number, greatest = Number.MAX_SAFE_INTEGER): number {
  const checked = number(place, value, least, greatest);
  if (!Number.isSafeInteger(checked)) throw errorAt(place, 'a whole number', value);
  return checked;
}

export function text(place: string, value: unknown): string {
  if (typeof value !== 'string') throw errorAt(place, 'text', value);
  return value;
}

export function choice<T extends string>(place: string, value: unknown, names: readonly T[]): T {
  const found = names.find((name) => name === value);
  if (found === undefined) throw errorAt(place, names.join(' or '), value);
  return found;
}

export function list<T>(
  place: string,
  value: unknown,
  entry: (place: string, value: unknown, index: number) => T,
  count?: number,
): T[] {
  if (!Array.isArray(value) || (count !== undefined && value.length !== count))
    throw errorAt(place, count === undefined ? 'a list' : `a list of ${count}`, value);
  return value.map((item, index) => entry(`${place}[${index}]`, item, index));
}

export function optional<T>(place: string, value: unknown, entry: (place: string, value: unknown) => T): T | null {
  return value === null || value === undefined ? null : entry(place, value);
}

/** SHA-256 in hexadecimal digits. */
export function hash(place: string, value: unknown): string {
  const found = text(place, value);
  if (!/^[0-9a-f]{64}$/.test(found)) throw errorAt(place, 'a SHA-256', value);
  return found;
}

/** Name of a file of the bundle; rejects paths that leave its folder. */
export function fileName(place: string, value: unknown): string {
  const name = text(place, value);
  if (!/^files\/[0-9a-f]{16}\.[a-z]+$/.test(name)) throw errorAt(place, 'the name of a file of the bundle', value);
  return name;
}
