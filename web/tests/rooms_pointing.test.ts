import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Pose } from '../src/control/pose';
import type { ScreenPoint } from '../src/rooms/hold';
import { createPointing } from '../src/rooms/pointing';
import type { Viewer } from '../src/show/viewer';
import type { HandRay } from '../src/xr/hands';

const POSE: Pose = { position: [0, 1.7, 0], yaw: 0, pitch: 0 };
const SHOWN = { grown: { radius: 20, strength: 1 } };

/** A viewer that counts its depth queries, and shows something 5 m ahead. */
class Looked {
  looks = 0;
  isMorphed = true;
  readonly viewer = {
    facts: { shown: SHOWN, entry: { center: [0, 0, 0] } },
    isMorphedAt: () => this.isMorphed,
    pointAt: () => this.look([0, 1.7, -18]),
    along: () => this.look(5),
  } as unknown as Viewer;

  private look<Found>(found: Found): Found {
    this.looks += 1;
    return found;
  }
}

/** No task. */
const nobody = (): null => null;

function hand(isPointing: boolean): HandRay {
  return { side: 'left', origin: [0, 1, 0], direction: [0, 0, -1], isPointing };
}

test('the GPU is queried at most 36 times a second, on the screen and in the headset', () => {
  const place: ScreenPoint = [0.5, 0.5];
  for (const hands of [null, [hand(true)]]) {
    const looked = new Looked();
    const bodyOf = createPointing(looked.viewer, 0.7, { point: place, isAlwaysPointing: false }, () => hands, nobody);
    for (let frame = 0; frame < 90; frame++) assert.ok(bodyOf(POSE, frame / 90).pointer);
    assert.ok(looked.looks <= 37 && looked.looks >= 25, String(looked.looks));
  }
});

test('pointing again queries at once', () => {
  const looked = new Looked();
  let hands = [hand(true)];
  const bodyOf = createPointing(looked.viewer, 0.7, { point: null, isAlwaysPointing: false }, () => hands, nobody);
  assert.deepEqual(bodyOf(POSE, 0).pointer, { begin: 'left', length: 5 });
  hands = [hand(false)];
  assert.equal(bodyOf(POSE, 0.001).pointer, null);
  hands = [hand(true)];
  bodyOf(POSE, 0.002);
  assert.equal(looked.looks, 2);
});

test('left of the divider a pointer ends at displayed positions, right of it at true ones', () => {
  const looked = new Looked();
  const user: Pose = { ...POSE, position: [2, 1.7, 0] };
  const end = (): readonly number[] => {
    const { right, pointer } = createPointing(looked.viewer, 0.7, { point: [0.5, 0.5], isAlwaysPointing: false }, () => null, nobody)(user, 0);
    assert.ok(right && pointer);
    const [x, y, z, w] = right.rotation;
    const along = [-2 * (x * z + w * y), -2 * (y * z - w * x), -1 + 2 * (x * x + y * y)];
    return right.position.map((value, axis) => value + pointer.length * (along[axis] ?? 0));
  };
  const apart = (point: readonly number[]): number => Math.hypot(...[0, 1.7, -18].map((at, n) => at - (point[n] ?? 0)));
  assert.ok(apart(end()) > 0.3, 'the morph moves what lies there');
  looked.isMorphed = false;
  assert.ok(apart(end()) < 1e-6);
});
