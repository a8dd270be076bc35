/** Walking and looking around with mouse, touch and keys. */
import type { Pose } from './pose';

/** Metres a second, and how much faster with Shift. */
const [SPEED, HASTE] = [1.4, 3] as const;
/** Radians a second by keys; radians by which dragging over the height of the picture turns. */
const [TURN, DRAG] = [1.2, 1.6] as const;
const STEEPEST = 1.5;

/** What keys do: metres to the right and ahead, and radians to the left and up, in units of their speeds. */
const KEYS: Readonly<Record<string, readonly [number, number, number, number]>> = {
  KeyW: [0, 1, 0, 0],
  KeyS: [0, -1, 0, 0],
  KeyA: [-1, 0, 0, 0],
  KeyD: [1, 0, 0, 0],
  ArrowUp: [0, 1, 0, 0],
  ArrowDown: [0, -1, 0, 0],
  ArrowLeft: [0, 0, 1, 0],
  ArrowRight: [0, 0, -1, 0],
  PageUp: [0, 0, 0, 1],
  PageDown: [0, 0, 0, -1],
};

export interface Walk {
  /** Where the user is after some seconds more. */
  update(seconds: number): Pose;
  setPose(pose: Pose): void;
}

/** `home` is where the Home key leads; the element must be focusable, and takes the keys. */
export function createWalk(element: HTMLElement, home: Pose): Walk {
  const held = new Set<string>();
  let pose = home;
  let isHasty = false;

  element.addEventListener('keydown', (event) => {
    isHasty = event.shiftKey;
    if (event.code === 'Home') pose = home;
    else if (event.code in KEYS && !event.ctrlKey && !event.metaKey && !event.altKey) held.add(event.code);
    else return;
    event.preventDefault();
  });
  element.addEventListener('keyup', (event) => {
    isHasty = event.shiftKey;
    held.delete(event.code);
  });
  element.addEventListener('blur', () => held.clear());
  element.addEventListener('pointerdown', (event) => element.setPointerCapture(event.pointerId));
  element.addEventListener('pointermove', (event) => {
    if (!element.hasPointerCapture(event.pointerId)) return;
    const scale = DRAG / element.clientHeight;
    turn(event.movementX * scale, event.movementY * scale);
  });

  function turn(left: number, up: number): void {
    const pitch = Math.min(Math.max(pose.pitch + up, -STEEPEST), STEEPEST);
    pose = { ...pose, yaw: (pose.yaw + left) % (2 * Math.PI), pitch };
  }

  return {
    update(seconds) {
      const [right, ahead, left, up] = [0, 1, 2, 3].map((n) =>
        [...held].reduce((sum, key) => sum + (KEYS[key]?.[n] ?? 0), 0),
      ) as [number, number, number, number];
      turn(left * TURN * seconds, up * TURN * seconds);
      const way = (SPEED * (isHasty ? HASTE : 1) * seconds) / Math.max(Math.hypot(right, ahead), 1);
      const [sine, cosine] = [Math.sin(pose.yaw), Math.cos(pose.yaw)];
      const [x, y, z] = pose.position;
      const position = [x + way * (right * cosine - ahead * sine), y, z - way * (right * sine + ahead * cosine)] as const;
      pose = { ...pose, position };
      return pose;
    },
    setPose(next) {
      pose = next;
    },
  };
}
