import assert from 'node:assert/strict';

/** Asserts that numbers differ by at most a tolerance from the expected ones. */
export function assertNear(found: number | readonly number[], expected: number | readonly number[], tolerance = 1e-9): void {
  const [values, targets] = [[found].flat(), [expected].flat()];
  assert.equal(values.length, targets.length);
  const isNear = values.every((value, index) => Math.abs(value - (targets[index] ?? NaN)) <= tolerance);
  assert.ok(isNear, `${values} instead of ${targets}`);
}
