import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Pose } from '../src/control/pose';
import type { ScreenPoint } from '../src/rooms/hold';
import { createPointing } from '../src/rooms/pointing';
import type { Viewer } from '../src/show/viewer';
import type { HandRay } from '../src/xr/hands';

const POSE: Pose = { position: [0, 1.7, 0], yaw: 0, pitch: 0 };
const SHOWN = { grown: { radius: 20, strength: 1 } };

/** Fake viewer that counts queries of depths; its geometry is 18 m ahead on the screen, 5 m along rays. */
class QueriedViewer {
  queryCount = 0;
  isMorphed = true;
  readonly viewer = {
    facts: { shown: SHOWN, entry: { center: [0, 0, 0] } },
    isMorphedAt: () => this.isMorphed,
    pointAt: () => this.query([0, 1.7, -18]),
    along: () => this.query(5),
  } as unknown as Viewer;

  private query<Result>(result: Result): Result {
    this.queryCount += 1;
    return result;
  }
}

const noActivity = (): null => null;

function hand(isPointing: boolean): HandRay {
  return { side: 'left', origin: [0, 1, 0], direction: [0, 0, -1], isPointing };
}

test('the GPU is queried at most 36 times a second, on the screen and in the headset', () => {
  const place: ScreenPoint = [0.5, 0.5];
  for (const hands of [null, [hand(true)]]) {
    const queried = new QueriedViewer();
    const bodyOf = createPointing(queried.viewer, 0.7, { point: place, isAlwaysPointing: false }, () => hands, noActivity);
    for (let frame = 0; frame < 90; frame++) assert.ok(bodyOf(POSE, frame / 90).pointer);
    assert.ok(queried.queryCount <= 37 && queried.queryCount >= 25, String(queried.queryCount));
  }
});

test('a new pointer is queried at once', () => {
  const queried = new QueriedViewer();
  let hands = [hand(true)];
  const bodyOf = createPointing(queried.viewer, 0.7, { point: null, isAlwaysPointing: false }, () => hands, noActivity);
  assert.deepEqual(bodyOf(POSE, 0).pointer, { begin: 'left', length: 5 });
  hands = [hand(false)];
  assert.equal(bodyOf(POSE, 0.001).pointer, null);
  hands = [hand(true)];
  bodyOf(POSE, 0.002);
  assert.equal(queried.queryCount, 2);
});

test('the morph is inverted for pointers right of the divider, but not left of it', () => {
  const queried = new QueriedViewer();
  const user: Pose = { ...POSE, position: [2, 1.7, 0] };
  const end = (): readonly number[] => {
    const hold = { point: [0.5, 0.5], isAlwaysPointing: false } as const;
    const { right, pointer } = createPointing(queried.viewer, 0.7, hold, () => null, noActivity)(user, 0);
    assert.ok(right && pointer);
    const [x, y, z, w] = right.rotation;
    const along = [-2 * (x * z + w * y), -2 * (y * z - w * x), -1 + 2 * (x * x + y * y)];
    return right.position.map((value, axis) => value + pointer.length * (along[axis] ?? 0));
  };
  const distanceFromShown = (point: readonly number[]): number => Math.hypot(...[0, 1.7, -18].map((at, n) => at - (point[n] ?? 0)));
  assert.ok(distanceFromShown(end()) > 0.3, 'the morph moves this point');
  queried.isMorphed = false;
  assert.ok(distanceFromShown(end()) < 1e-6);
});
