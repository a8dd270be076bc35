import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bytes, bytesOf, count, metres, milliseconds, percent, rate } from '../src/ui/format';

/** Replaces the no-break space between numbers and units. */
const plain = (text: string): string => text.replaceAll('\u00a0', ' ');

const CASES: readonly (readonly [string, string])[] = [
  [bytes(0), '0 B'],
  [bytes(999), '999 B'],
  [bytes(999.6), '1 kB'],
  [bytes(12_345), '12 kB'],
  [bytes(999_499), '999 kB'],
  [bytes(999_500), '1.0 MB'],
  [bytes(45_100_000), '45.1 MB'],
  [bytes(99_960_000), '100 MB'],
  [bytes(1.2e9), '1.2 GB'],
  [bytes(5e16), '50000 TB'],
  [bytesOf(28_200_000, 45_100_000), '28.2 of 45.1 MB'],
  [bytesOf(0, 45_100_000), '0.0 of 45.1 MB'],
  [bytesOf(3, 2), '3 of 2 B'],
  [rate(null), 'idle'],
  [rate(0), '0 b/s'],
  [rate(640_000), '640 kb/s'],
  [rate(48.2e6), '48.2 Mb/s'],
  [count(0), '0'],
  [count(640_886), '640,886'],
  [count(999_999), '999,999'],
  [count(1_240_000), '1.24 million'],
  [count(999_400_000), '999.40 million'],
  [count(1.5e9), '1.50 billion'],
  [percent(0, 10), '0 %'],
  [percent(1, 1000), '< 1 %'],
  [percent(999, 1000), '99 %'],
  [percent(10, 10), '100 %'],
  [percent(11, 10), '100 %'],
  [percent(0, 0), '100 %'],
  [milliseconds(11.24), '11.2 ms'],
  [milliseconds(99.96), '100 ms'],
  [metres(0), '0.00 m'],
  [metres(0.996), '1.0 m'],
  [metres(22), '22.0 m'],
  [metres(99.96), '100 m'],
  [metres(3210), '3.2 km'],
];

test('numbers have prefixes of units, and few digits', () => {
  for (const [found, expected] of CASES) assert.equal(plain(found), expected);
});

test('invalid amounts become a dash', () => {
  for (const invalid of [Number.NaN, Number.POSITIVE_INFINITY, -1]) {
    const texts = [bytes, rate, count, milliseconds, metres].map((format) => format(invalid));
    assert.deepEqual([...texts, bytesOf(1, invalid), percent(invalid, 1)], Array(7).fill('–'));
  }
});
