/** Checks of parsed JSON: each returns the value, or throws an error that names its path in the manifest. */
import { BundleError } from './error';

export type Fields = Readonly<Record<string, unknown>>;

function errorAt(path: string, expected: string, got: unknown): BundleError {
  const text = JSON.stringify(got) ?? 'nothing';
  return new BundleError(`manifest.json: ${path}: expected ${expected}, got ${text.slice(0, 60)}`);
}

export function object(path: string, value: unknown): Fields {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw errorAt(path, 'an object', value);
  return value as Fields;
}

export function number(path: string, value: unknown, least: number, greatest = Number.MAX_VALUE): number {
  const isWithin = typeof value === 'number' && value >= least && value <= greatest;
  const expected = greatest < Number.MAX_SAFE_INTEGER ? `from ${least} to ${greatest}` : `of at least ${least}`;
  if (!isWithin) throw errorAt(path, `a number ${expected}`, value);
  return value;
}

export function integer(path: string, value: unknown, least: number, greatest = Number.MAX_SAFE_INTEGER): number {
  const checked = number(path, value, least, greatest);
  if (!Number.isSafeInteger(checked)) throw errorAt(path, 'a whole number', value);
  return checked;
}

export function text(path: string, value: unknown): string {
  if (typeof value !== 'string') throw errorAt(path, 'text', value);
  return value;
}

export function choice<T extends string>(path: string, value: unknown, names: readonly T[]): T {
  const found = names.find((name) => name === value);
  if (found === undefined) throw errorAt(path, names.join(' or '), value);
  return found;
}

export function list<T>(
  path: string,
  value: unknown,
  entry: (path: string, value: unknown, index: number) => T,
  count?: number,
): T[] {
  if (!Array.isArray(value) || (count !== undefined && value.length !== count))
    throw errorAt(path, count === undefined ? 'a list' : `a list of ${count}`, value);
  return value.map((item, index) => entry(`${path}[${index}]`, item, index));
}

export function optional<T>(path: string, value: unknown, entry: (path: string, value: unknown) => T): T | null {
  return value === null || value === undefined ? null : entry(path, value);
}

/** Checks a SHA-256 in hexadecimal digits. */
export function hash(path: string, value: unknown): string {
  const found = text(path, value);
  if (!/^[0-9a-f]{64}$/.test(found)) throw errorAt(path, 'a SHA-256', value);
  return found;
}

/** Checks the name of a file of the bundle; rejects paths that leave its folder. */
export function fileName(path: string, value: unknown): string {
  const name = text(path, value);
  if (!/^files\/[0-9a-f]{16}\.[a-z]+$/.test(name)) throw errorAt(path, 'the name of a file of the bundle', value);
  return name;
}
