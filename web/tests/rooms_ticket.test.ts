import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Connection } from '../src/rooms/connection';
import { createTicketStore, followPage } from '../src/rooms/ticket';
import { createStorage } from './support/storage';

test('a ticket is stored for its room only, until it is taken', () => {
  const storage = createStorage();
  const [hall, other] = ['ws://h/rooms/hall', 'ws://h/rooms/other'].map((at) => createTicketStore(at, () => storage));
  assert.deepEqual(hall?.take(), new Uint8Array());
  hall?.put(new Uint8Array([0, 1, 254]));
  assert.deepEqual(other?.take(), new Uint8Array());
  assert.deepEqual(hall?.take(), new Uint8Array([0, 1, 254]));
  assert.deepEqual(hall?.take(), new Uint8Array());
  assert.equal(storage.entries.size, 0);
  // Malformed tickets are not sent.
  for (const text of ['x', '1', '00'.repeat(256), 'zz']) {
    hall?.put(new Uint8Array([1]));
    for (const key of storage.entries.keys()) storage.entries.set(key, text);
    assert.equal(hall?.take().length, 0);
  }
});

test('without a storage there is no ticket, and no error', () => {
  const tickets = createTicketStore('ws://h/rooms/hall', () => {
    throw new Error('forbidden');
  });
  tickets.put(new Uint8Array([1]));
  assert.equal(tickets.take().length, 0);
});

test('a hidden page leaves and stores its ticket, and joins again when it is shown', () => {
  const [page, storage] = [new EventTarget(), createStorage()];
  const calls: string[] = [];
  const connection = {
    state: { kind: 'here' },
    ticket: new Uint8Array([5]),
    leave: (isImmediate: boolean) => calls.push(`leave ${isImmediate}`),
    retry: () => calls.push('retry'),
  };
  followPage(connection as unknown as Connection, createTicketStore('ws://h/rooms/x', () => storage), page);
  page.dispatchEvent(new Event('pageshow'));
  assert.deepEqual(calls, []);
  page.dispatchEvent(new Event('pagehide'));
  assert.deepEqual([calls, [...storage.entries.values()]], [['leave true'], ['05']]);
  page.dispatchEvent(new Event('pageshow'));
  assert.deepEqual([calls, storage.entries.size], [['leave true', 'retry'], 0]);
  // If the user has left before, nothing is stored, and the page does not join again.
  connection.state.kind = 'ended';
  page.dispatchEvent(new Event('pagehide'));
  page.dispatchEvent(new Event('pageshow'));
  assert.deepEqual([calls.length, storage.entries.size], [2, 0]);
});
