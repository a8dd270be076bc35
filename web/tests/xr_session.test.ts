import assert from 'node:assert/strict';
import { test } from 'node:test';
import { whyNoHeadset } from '../src/xr/session';

function system(answer: () => Promise<boolean>): XRSystem {
  return { isSessionSupported: answer } as unknown as XRSystem;
}

test('a sentence explains why no headset can be entered', async () => {
  const missing = system(async () => false);
  const forbidden = system(async () => {
    throw new DOMException('no', 'SecurityError');
  });
  assert.match((await whyNoHeadset(undefined, false)) ?? '', /https/);
  assert.match((await whyNoHeadset(undefined, true)) ?? '', /This browser/);
  assert.match((await whyNoHeadset(missing, true)) ?? '', /connected/);
  assert.match((await whyNoHeadset(forbidden, true)) ?? '', /may not use/);
  assert.equal(await whyNoHeadset(system(async () => true), true), null);
});
