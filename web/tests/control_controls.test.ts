import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Controls, createControls } from '../src/control/controls';
import { type Pad, readPads } from '../src/control/drive';
import { createTaps, type Thumb } from '../src/control/pointers';
import type { Pose } from '../src/control/pose';
import { listenToKeys } from '../src/ui/help';
import { nextShare } from '../src/ui/overlays';
import { fakeElement, release, point, press, send } from './support/fakes';
import { assertNear } from './support/near';

const START: Pose = { position: [0, 1.7, 0], yaw: 0, pitch: 0 };

function createTestControls(pads: readonly (Pad | null)[] = []) {
  const [element, keys] = [fakeElement(), new EventTarget()];
  const [poses, thumbs]: [Pose[], (Thumb | null)[]] = [[], []];
  const places: [number, number][] = [];
  const controls: Controls = createControls(element, {
    start: START,
    keys,
    pads: () => pads,
    isSudden: () => true,
    onChange: (pose) => poses.push(pose),
    onThumb: (thumb) => thumbs.push(thumb),
    onGo: (x, y) => places.push([x, y]),
  });
  return { element, keys, controls, poses, thumbs, places };
}

test('keys walk while they are held', () => {
  const { keys, controls } = createTestControls();
  assert.ok(press(keys, 'KeyW').defaultPrevented);
  assertNear(controls.update(0.5).position[2], -0.8);
  press(keys, 'KeyD');
  const { position } = controls.update(0.5);
  assertNear(Math.hypot(position[0], position[2] + 0.8), 0.8);
  release(keys, 'KeyW');
  release(keys, 'KeyD');
  assert.deepEqual(controls.update(0.5).position, position);
});

test('shift runs, opposite keys cancel each other, losing the focus stops', () => {
  const { keys, controls } = createTestControls();
  press(keys, 'ArrowUp', { shiftKey: true });
  assertNear(controls.update(0.5).position[2], -2.4);
  press(keys, 'KeyS');
  assertNear(controls.update(0.5).position[2], -2.4);
  release(keys, 'KeyS');
  send(keys, 'blur');
  assertNear(controls.update(0.5).position[2], -2.4);
});

test('arrow keys turn, and other keys and shortcuts are ignored', () => {
  const { keys, controls } = createTestControls();
  for (const modifier of ['ctrlKey', 'metaKey', 'altKey']) {
    assert.ok(!press(keys, 'KeyW', { [modifier]: true }).defaultPrevented);
  }
  assert.ok(!press(keys, 'KeyB').defaultPrevented);
  assert.ok(!press(keys, 'constructor').defaultPrevented);
  assert.deepEqual(controls.update(0.5), START);
  press(keys, 'ArrowLeft');
  assertNear(controls.update(0.5).yaw, 0.7);
});

test('an update by zero or invalid seconds does not move, and a long pause counts as half a second', () => {
  const { keys, controls, poses } = createTestControls();
  press(keys, 'KeyW');
  for (const seconds of [0, -1, Number.NaN]) assert.deepEqual(controls.update(seconds), START);
  assert.equal(poses.length, 0);
  assertNear(controls.update(3600).position[2], -0.8);
  assert.equal(poses.length, 1);
});

test('dragging turns the head; moves without a button do not', () => {
  const { element, controls } = createTestControls();
  point(element, 'pointermove', 500, 300);
  point(element, 'pointerdown', 100, 100);
  assert.ok(element.captured.has(1));
  point(element, 'pointermove', 250, 100);
  point(element, 'pointermove', 400, 250);
  point(element, 'pointerup', 400, 250);
  point(element, 'pointermove', 700, 500);
  const { yaw, pitch } = controls.update(0.1);
  assertNear(yaw, 0.8);
  assertNear(pitch, 0.4);
});

test('a locked pointer turns the head in the direction of its movement', () => {
  const { element, controls } = createTestControls();
  point(element, 'pointerdown', 100, 100);
  point(element, 'pointerup', 100, 100);
  controls.lookAround();
  point(element, 'pointermove', 100, 100, { movementX: 150, movementY: 75 });
  assertNear(controls.update(0.1).yaw, -0.4);
  assertNear(controls.update(0.1).pitch, -0.2);
});

test('a double click and a double tap request the place in the picture', () => {
  const { element, places } = createTestControls();
  send(element, 'dblclick', { clientX: 200, clientY: 150 });
  const touch = { pointerId: 4, pointerType: 'touch' };
  for (let tap = 0; tap < 2; tap++) {
    point(element, 'pointerdown', 600, 300, touch);
    point(element, 'pointerup', 600, 300, touch);
  }
  // Some browsers report both taps as a double click, too.
  send(element, 'dblclick', { clientX: 600, clientY: 300 });
  assert.deepEqual(places, [[0.25, 0.25], [0.75, 0.5]]);
});

test('the left thumb walks while the right one looks', () => {
  const { element, controls, thumbs } = createTestControls();
  const [left, right] = [{ pointerId: 7, pointerType: 'touch' }, { pointerId: 9, pointerType: 'touch' }];
  point(element, 'pointerdown', 100, 500, left);
  point(element, 'pointermove', 100, 400, left);
  point(element, 'pointerdown', 700, 500, right);
  point(element, 'pointermove', 550, 500, right);
  assertNear(controls.update(0.5).yaw, -0.4);
  const { position } = controls.update(0);
  assertNear(Math.hypot(position[0], position[2]), 0.8);
  assert.deepEqual(thumbs.at(-1), { x: 100, y: 500, right: 0, down: -100 });
  point(element, 'pointercancel', 100, 400, left);
  assert.equal(thumbs.at(-1), null);
  assert.deepEqual(controls.update(0.5).position, position);
});

test('a resting thumb does not drift', () => {
  const { element, controls } = createTestControls();
  point(element, 'pointerdown', 100, 500, { pointerType: 'touch' });
  point(element, 'pointermove', 103, 504, { pointerType: 'touch' });
  assert.deepEqual(controls.update(0.5).position, START.position);
});

test('a change of mode causes no jump, and releases fingers', () => {
  const { element, controls } = createTestControls();
  point(element, 'pointerdown', 100, 500, { pointerType: 'touch' });
  point(element, 'pointermove', 100, 400, { pointerType: 'touch' });
  const before = controls.update(0.2);
  controls.setMode('orbit');
  assert.equal(controls.mode, 'orbit');
  assert.deepEqual(controls.update(0.2), before);
  controls.setMode('walk');
  assert.deepEqual(controls.update(0.2), before);
});

test('in an orbit the wheel and two fingers zoom, and two fingers pan', () => {
  const { element, controls } = createTestControls();
  assert.ok(!send(element, 'wheel', { deltaY: 100, deltaMode: 0 }).defaultPrevented);
  controls.setMode('orbit');
  assert.ok(send(element, 'wheel', { deltaY: 100, deltaMode: 0, ctrlKey: false }).defaultPrevented);
  const zAfterWheel = controls.update(0).position[2];
  assertNear(zAfterWheel, 4 * Math.exp(0.15) - 4);
  const [first, second] = [{ pointerId: 7, pointerType: 'touch' }, { pointerId: 9, pointerType: 'touch' }];
  point(element, 'pointerdown', 300, 300, first);
  point(element, 'pointerdown', 500, 300, second);
  point(element, 'pointermove', 200, 300, first);
  point(element, 'pointermove', 600, 300, second);
  const afterPinch = controls.update(0).position;
  assertNear(afterPinch[2] + 4, (zAfterWheel + 4) / 2);
  point(element, 'pointermove', 200, 360, first);
  point(element, 'pointermove', 600, 360, second);
  assert.ok(controls.update(0).position[1] > 1.8);
});

test('home takes effect at once, and a limit holds for both modes', () => {
  const { keys, controls } = createTestControls();
  controls.setPose({ position: [3, 2, 1], yaw: 1, pitch: 0.1 });
  assert.deepEqual(controls.update(0), { position: [3, 2, 1], yaw: 1, pitch: 0.1 });
  controls.setPose(START);
  const limit = { center: [0, 0, 0], metres: 2 } as const;
  controls.setBounds({ soft: [limit], hard: [limit] });
  press(keys, 'KeyS', { shiftKey: false });
  for (let frame = 0; frame < 100; frame++) controls.update(0.1);
  assert.ok(controls.update(0.1).position[2] <= 2 && controls.update(0.1).position[2] > 1.9);
  controls.setMode('orbit');
  for (let frame = 0; frame < 100; frame++) controls.update(0.1);
  assert.ok(controls.update(0.1).position[2] <= 2 + 1e-9);
  controls.setBounds(null);
  controls.setMode('walk');
  for (let frame = 0; frame < 10; frame++) controls.update(0.1);
  assert.ok(controls.update(0.1).position[2] > 3);
});

test('after dispose events are ignored', () => {
  const { element, keys, controls } = createTestControls();
  controls.dispose();
  press(keys, 'KeyW');
  point(element, 'pointerdown', 100, 100);
  point(element, 'pointermove', 400, 100);
  assert.deepEqual(controls.update(0.5), START);
});

const PAD: Pad = { connected: true, mapping: 'standard', axes: [0, -1, 0.5, 0], buttons: [] };

test('sticks walk and look; at rest or with an unknown layout they do nothing', () => {
  const { controls } = createTestControls([null, PAD]);
  const { yaw } = controls.update(0.5);
  assertNear(yaw, (-0.7 * (0.5 - 0.18)) / (1 - 0.18));
  assert.ok(controls.update(0).position[2] < -0.7);
  const idlePads = [{ mapping: '' }, { connected: false }, { axes: [0.1, -0.1, 0.05, Number.NaN] }, { axes: [] }];
  for (const change of idlePads) {
    const drive = readPads([{ ...PAD, ...change }]);
    assert.deepEqual([drive.right, drive.ahead, drive.turn, drive.look], [0, 0, 0, 0]);
  }
  const buttons = Array.from({ length: 11 }, (_, number) => ({ pressed: number === 10 }));
  assert.ok(readPads([{ ...PAD, buttons }]).isRunning);
});

test('keys move the divider within the picture, and remove it', () => {
  assertNear(nextShare('ArrowLeft', 0.5) ?? NaN, 0.49);
  assertNear(nextShare('PageUp', 0.95) ?? NaN, 1);
  assert.equal(nextShare('Home', 0.5), 0);
  assert.equal(nextShare('Escape', 0.5), null);
  for (const key of ['w', 'constructor', 'Tab']) assert.equal(nextShare(key, 0.5), undefined);
});

test('each key press runs a command once, but not if the key walks or belongs to a shortcut', () => {
  const keys = new EventTarget();
  const commands: string[] = [];
  listenToKeys((name) => commands.push(name), keys);
  press(keys, 'KeyC', { key: 'C' });
  press(keys, 'KeyC', { key: 'c', repeat: true });
  press(keys, 'KeyC', { key: 'c', ctrlKey: true });
  press(keys, 'Slash', { key: '?', shiftKey: true });
  press(keys, 'Home', { key: 'Home' });
  // On other keyboard layouts the key KeyP is an L, and the key KeyD, which walks to the right, may be a P.
  press(keys, 'KeyP', { key: 'l' });
  press(keys, 'KeyD', { key: 'p' });
  press(keys, 'KeyQ', { key: '__proto__' });
  assert.deepEqual(commands, ['split', 'help', 'home', 'link']);
});

test('a press during pointer lock neither captures the pointer nor stops looking around', () => {
  const { element, controls } = createTestControls();
  controls.lookAround();
  point(element, 'pointerdown', 400, 300);
  point(element, 'pointermove', 400, 300, { movementX: 60 });
  assertNear(controls.update(0.1).yaw, -60 * 1.6 / 600);
  assert.equal(element.captured.size, 0);
});

function countDoubleTaps(events: readonly (readonly ['down' | 'up', number, number, number, number?])[]): number {
  let count = 0;
  const taps = createTaps(() => (count += 1));
  for (const [name, timeStamp, clientX, clientY, pointerId = 1] of events) {
    taps[name]({ timeStamp, clientX, clientY, pointerId });
  }
  return count;
}

test('two taps at one place are reported once', () => {
  const two = [['down', 0, 50, 50], ['up', 90, 52, 50], ['down', 250, 55, 52], ['up', 330, 55, 52]] as const;
  assert.equal(countDoubleTaps(two), 1);
  assert.equal(countDoubleTaps([...two, ['down', 450, 55, 52], ['up', 500, 55, 52]]), 1);
});

test('drags, slow taps, taps elsewhere and two fingers are not double taps', () => {
  const [first, second] = [[['down', 0, 50, 50], ['up', 90, 50, 50]], [['down', 200, 50, 50], ['up', 280, 50, 50]]] as const;
  assert.equal(countDoubleTaps([...first, ...second]), 1);
  assert.equal(countDoubleTaps([['down', 0, 50, 50], ['up', 90, 90, 50], ...second]), 0);
  assert.equal(countDoubleTaps([['down', 0, 50, 50], ['up', 400, 50, 50], ['down', 450, 50, 50], ['up', 500, 50, 50]]), 0);
  assert.equal(countDoubleTaps([...first, ['down', 600, 50, 50], ['up', 650, 50, 50]]), 0);
  assert.equal(countDoubleTaps([...first, ['down', 200, 90, 50], ['up', 250, 90, 50]]), 0);
  assert.equal(countDoubleTaps([...first, ['down', 200, 50, 50], ['down', 210, 300, 50, 2], ['up', 280, 50, 50]]), 0);
});
