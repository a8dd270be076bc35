import assert from 'node:assert/strict';
import { test } from 'node:test';
import { reasonForNoHeadset } from '../src/xr/session';

function createSystem(answer: () => Promise<boolean>): XRSystem {
  return { isSessionSupported: answer } as unknown as XRSystem;
}

test('a sentence says why there is no headset', async () => {
  const missing = createSystem(async () => false);
  const forbidden = createSystem(async () => {
    throw new DOMException('no', 'SecurityError');
  });
  assert.match((await reasonForNoHeadset(undefined, false)) ?? '', /https/);
  assert.match((await reasonForNoHeadset(undefined, true)) ?? '', /This browser/);
  assert.match((await reasonForNoHeadset(missing, true)) ?? '', /connected/);
  assert.match((await reasonForNoHeadset(forbidden, true)) ?? '', /may not use/);
  assert.equal(await reasonForNoHeadset(createSystem(async () => true), true), null);
});
