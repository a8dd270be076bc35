import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createOutbox, readSignal, type Signal, writeSignal } from '../src/peers/call';
import { MAX_FILES_PER_MESSAGE, type Message, PART, readMessage, writeMessage } from '../src/peers/messages';
import { precedes } from '../src/peers/share';
import { bytesOf, hexOf } from '../src/base/bytes';
import { LruCache } from '../src/base/cache';
import { FrameError } from '../src/rooms/bytes';
import { createBucket } from '../src/rooms/clock';
import { makeContent, steppedClock } from './support/peers';
import { randomOf } from './support/random';

const KEY = '00ff'.repeat(16);
const SDP = 'v=0\r\nm=application 9 UDP/DTLS/SCTP webrtc-datachannel\r\na=candidate:1 1 udp 1 10.0.0.1 1 typ host\r\n';

const MESSAGES: readonly (readonly [Message, string])[] = [
  [{ kind: 'tell', holding: 'gone', keys: [] }, '0100'],
  [{ kind: 'tell', holding: 'coming', keys: [KEY] }, '0101' + KEY],
  [{ kind: 'tell', holding: 'here', keys: [KEY, KEY] }, '0102' + KEY + KEY],
  [{ kind: 'want', request: 0x01020304, key: KEY }, '0204030201' + KEY],
  [{ kind: 'part', request: 7, data: Uint8Array.from([1, 2]) }, '03070000000102'],
  [{ kind: 'wait', request: 7, bytes: 256 }, '040700000000010000'],
  [{ kind: 'none', request: 7 }, '0507000000'],
  [{ kind: 'cancel', request: 7 }, '0607000000'],
];

test('messages equal the bytes of the table, and are parsed back', () => {
  for (const [message, expected] of MESSAGES) {
    assert.equal(hexOf(writeMessage(message)), expected);
    assert.deepEqual(readMessage(bytesOf(expected)), message);
  }
});

test('malformed messages are rejected', () => {
  const wrong = ['', '00', '07', '01', '0103', '0100ff', '02', '0204030201ff', '05', '050700000000', '0407000000'];
  for (const text of wrong) assert.throws(() => readMessage(bytesOf(text)), FrameError, text);
  assert.throws(() => readMessage(new Uint8Array(6 + PART).fill(3)), FrameError);
  assert.throws(() => readMessage(Uint8Array.from([1, 0, ...new Uint8Array(32 * (MAX_FILES_PER_MESSAGE + 20))])), FrameError);
  const random = randomOf(5);
  for (let trial = 0; trial < 3000; trial++) {
    const garbage = Uint8Array.from({ length: Math.floor(80 * random()) }, () => Math.floor(256 * random()));
    if (trial % 2) garbage[0] = 1 + (trial % 6);
    try {
      assert.deepEqual(writeMessage(readMessage(garbage)), garbage);
    } catch (error) {
      assert.ok(error instanceof FrameError);
    }
  }
});

test('signals are encoded and decoded', () => {
  const signals: readonly Signal[] = [
    { kind: 'offer', attempt: 0x01020304, sdp: SDP },
    { kind: 'answer', attempt: 5, sdp: SDP },
    { kind: 'no', attempt: 0, sdp: '' },
  ];
  for (const signal of signals) assert.deepEqual(readSignal(writeSignal(signal)), signal);
  assert.equal(hexOf(writeSignal(signals[2] as Signal)), '010200000000');
});

test('signals that do not describe exactly one data channel are rejected', () => {
  const head = '01' + '00' + '00000000';
  for (const text of ['', '02', '0103', head, '010200000000ff', head + 'ff', '010000']) {
    assert.throws(() => readSignal(bytesOf(text)), FrameError, text);
  }
  const audio = SDP + 'm=audio 9 UDP/TLS/RTP/SAVPF 111\r\n';
  for (const sdp of ['', 'v=0', audio, SDP.replace('application', 'video')]) {
    assert.throws(() => readSignal(writeSignal({ kind: 'offer', attempt: 1, sdp })), FrameError);
  }
  assert.throws(() => writeSignal({ kind: 'offer', attempt: 1, sdp: 'x'.repeat(8193) }), FrameError);
  assert.throws(() => readSignal(Uint8Array.from([1, 0, 0, 0, 0, 0, ...new Uint8Array(8193).fill(97)])), FrameError);
});

test('only the first UDP host candidates of a description are used, at most eight', () => {
  const line = (host: number, transport: string, kind: string): string =>
    `a=candidate:${host} 1 ${transport} 1 10.0.0.${host} 9 typ ${kind}\r\n`;
  const hosts = [...Array(12).keys()].map((host) => line(host, 'udp', 'host'));
  const others = [line(50, 'tcp', 'host'), line(51, 'udp', 'srflx raddr 10.0.0.1 rport 9'), ' ' + line(52, 'udp', 'host')];
  const sdp = SDP + others.join('') + hosts.join('') + 'a=end\r\n';
  const read = readSignal(writeSignal({ kind: 'offer', attempt: 1, sdp }));
  // `SDP` itself has the first of the eight.
  assert.equal(read.sdp, SDP + hosts.slice(0, 7).join('') + 'a=end\r\n');
});

test('all users agree on who requests a file from the server, and the shares are equal', () => {
  const users = [3, 4, 900, 65_535, 12, 13, 14, 15];
  const counts = new Map<number, number>();
  for (let file = 0; file < 2000; file++) {
    const { sha256: key } = makeContent(1 + file, 0).entry;
    const ordersByUser = users.map((_, turn) => [...users.slice(turn), ...users.slice(0, turn)]);
    const firsts = ordersByUser.map((order) => order.reduce((best, user) => (precedes(user, best, key) ? user : best)));
    assert.equal(new Set(firsts).size, 1);
    counts.set(firsts[0] ?? -1, (counts.get(firsts[0] ?? -1) ?? 0) + 1);
  }
  for (const user of users) assert.ok(Math.abs((counts.get(user) ?? 0) - 250) < 80, `${counts.get(user)}`);
});

test('a cache evicts the least recently used values, but never the newest value', () => {
  const cache = new LruCache<string>(100);
  assert.deepEqual(cache.add('a', 'A', 40), []);
  assert.deepEqual(cache.add('b', 'B', 40), []);
  assert.equal(cache.get('a'), 'A');
  assert.deepEqual(cache.add('c', 'C', 40), ['b']);
  assert.deepEqual(cache.add('c', 'C', 60), []);
  assert.deepEqual([...cache.keys].sort(), ['a', 'c']);
  assert.equal(cache.get('b'), undefined);
  assert.deepEqual(cache.add('d', 'D', 101), ['a', 'c']);
  cache.delete('d');
  assert.equal(cache.has('d'), false);
  assert.deepEqual(cache.add('e', 'E', 100), []);
});

test('a token bucket allows a rate, and a burst at first', () => {
  let time = 0;
  const bucket = createBucket(10, 20, () => time);
  assert.ok(bucket.take(20));
  assert.equal(bucket.take(1), false);
  assert.equal(bucket.secondsTo(5), 0.5);
  time = 0.5;
  assert.ok(bucket.take(5));
  time = 100;
  assert.equal(bucket.take(21), false);
});

test('signals are sent no faster than a room accepts them', async () => {
  const clock = steppedClock();
  const sent: number[] = [];
  const outbox = createOutbox((user) => sent.push(user), clock);
  for (let user = 0; user < 20; user++) outbox.send(user, new Uint8Array(1000));
  assert.equal(sent.length, 12);
  await clock.advance(0.25);
  assert.ok(sent.length > 12 && sent.length <= 19);
  await clock.advance(0.5);
  assert.deepEqual(sent, [...Array(20).keys()]);
  for (let user = 0; user < 20; user++) outbox.send(user, new Uint8Array(8000));
  outbox.clear();
  await clock.advance(5);
  assert.ok(sent.length <= 22);
});
