import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createChoice, refusalOfPage, refusalOfServer, SWITCHED_OFF } from '../src/peers/choice';
import { createStorage } from './support/storage';

test('the choice of a user is stored for later pages', () => {
  const storage = createStorage();
  const choice = createChoice(() => storage);
  assert.ok(choice.isOn);
  choice.set(false);
  assert.equal(choice.isOn, false);
  const next = createChoice(() => storage);
  assert.equal(next.isOn, false);
  assert.equal(refusalOfPage(new URLSearchParams(), next), SWITCHED_OFF);
  next.set(true);
  assert.ok(createChoice(() => storage).isOn);
  assert.notEqual(refusalOfPage(new URLSearchParams(), next), SWITCHED_OFF);
});

test('if the browser forbids storage, the choice holds for the page', () => {
  const choice = createChoice(() => {
    throw new Error('forbidden');
  });
  assert.ok(choice.isOn);
  choice.set(false);
  assert.equal(choice.isOn, false);
});

test('a page shares files if its address, its browser and the server allow it', () => {
  const choice = createChoice(createStorage);
  assert.match(refusalOfPage(new URLSearchParams('peers=off'), choice) ?? '', /address/);
  assert.match(refusalOfPage(new URLSearchParams(), choice) ?? '', /WebRTC/);
  assert.equal(refusalOfServer({ peers: true, datagrams: null }), null);
  assert.match(refusalOfServer({ peers: false, datagrams: null }) ?? '', /server does not allow/);
  assert.match(refusalOfServer(null) ?? '', /does not say/);
});
