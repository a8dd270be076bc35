import assert from 'node:assert/strict';
import { test } from 'node:test';
import { limitRings } from '../src/bundle/contents';
import { parseManifest } from '../src/bundle/parse';
import { asManifest, manifest } from './support/manifest';

test('a bundle is limited to the requested rings', () => {
  const read = parseManifest(asManifest(manifest()));
  const count = read.regions[0]?.rings.length ?? 0;
  assert.ok(count > 1);
  assert.equal(limitRings(null, read), read);
  for (const [last, rings] of [['0', 1], ['1', 2], ['9999', count]] as const) {
    assert.equal(limitRings(last, read).regions[0]?.rings.length, rings);
  }
});

test('invalid ring numbers are rejected', () => {
  const read = parseManifest(asManifest(manifest()));
  for (const last of ['', '-1', '1.5', 'two', '99999']) {
    assert.throws(() => limitRings(last, read), /rings: expected the number of a ring, got/);
  }
});
