import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readLink, writeLink } from '../src/control/pose';
import { randomOf } from './support/random';

test('a link restores its pose', () => {
  for (let number = 0; number < 200; number++) {
    const chance = (factor: number): number => Math.sin(factor * 12.9898 * (number + 1));
    const position = [1e4 * chance(1), 50 * chance(2), 1e4 * chance(3)] as const;
    const pose = { position, yaw: 3 * chance(4), pitch: 1.4 * chance(5) };
    const found = readLink(writeLink(pose));
    assert.ok(found);
    found.position.forEach((value, axis) => assert.ok(Math.abs(value - (pose.position[axis] ?? 0)) <= 0.0005001));
    assert.ok(Math.abs(found.yaw - pose.yaw) <= 0.000051 && Math.abs(found.pitch - pose.pitch) <= 0.000051);
    assert.equal(writeLink(found), writeLink(pose));
  }
});

test('links are short, and equal for equal views', () => {
  const pose = { position: [3, 1.7, -0] as const, yaw: 2 * Math.PI + 0.5, pitch: -0 };
  assert.equal(writeLink(pose), '#p=3,1.7,0&yaw=0.5&pitch=0');
});

test('missing angles are 0', () => {
  assert.deepEqual(readLink('#p=1,2,3'), { position: [1, 2, 3], yaw: 0, pitch: 0 });
  assert.deepEqual(readLink('p=1%2C2%2C-3e0&other=7'), { position: [1, 2, -3], yaw: 0, pitch: 0 });
});

test('a link cannot turn the head over', () => {
  assert.equal(readLink('#p=0,0,0&pitch=9')?.pitch, 1.5);
  assert.ok(Math.abs(readLink('#p=0,0,0&yaw=1e6')?.yaw ?? 9) <= Math.PI);
});

const MALFORMED = [
  '',
  '#',
  '#p',
  '#p=',
  '#p=1,2',
  '#p=1,2,3,4',
  '#p=1,2,',
  '#p=,,',
  '#p=a,b,c',
  '#p=NaN,0,0',
  '#p=Infinity,0,0',
  '#p=1e999,0,0',
  '#p=4e7,0,0',
  '#p=0x10,0,0',
  '#p=1_0,0,0',
  '#p= 1,0,0\u0000',
  '#p=%,%25,%zz',
  '#p=1,2,3&yaw=',
  '#p=1,2,3&yaw=north',
  '#p=1,2,3&pitch=1e400',
  '#p=1,2,3&yaw=<img src=x onerror=alert(1)>',
  '#__proto__=1&constructor=2',
  `#p=${'1'.repeat(400)},0,0`,
  `#p=1,2,3&${'a'.repeat(100_000)}`,
  `#p=${'1,'.repeat(200)}`,
];

test('malformed fragments give no pose and no error', () => {
  for (const fragment of MALFORMED) assert.equal(readLink(fragment), null, fragment.slice(0, 60));
});

test('random fragments give no pose or a finite one', () => {
  const random = randomOf(1);
  const letters = '#p=&yawitch,.-+e0123456789%\u0000é;';
  for (let number = 0; number < 5000; number++) {
    const letter = (): string => letters[Math.floor(letters.length * random())] ?? '';
    const tail = Array.from({ length: Math.floor(30 * random()) }, letter);
    const pose = readLink(`#p=${tail.join('')}`);
    if (pose) assert.ok([...pose.position, pose.yaw, pose.pitch].every(Number.isFinite));
  }
});
