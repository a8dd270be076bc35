/** Sends the user's poses at a limited rate, and only while the user moves. */
import type { Body, Placement, Pointer } from './pose';

/** Poses per second. */
const RATE = 72;
/** Greatest changes that do not count as movement: metres; component of a rotation; relative length of a pointer. */
const [MAX_SHIFT, MAX_TURN, MAX_LENGTH_CHANGE] = [1e-3, 5e-4, 1e-3] as const;

/** Creates a sender. `send` sends a pose and returns whether it was sent; `stops` says that a pause follows. */
export function createSender(send: (body: Body, stops: boolean) => boolean) {
  let lastBody: Body | null = null;
  let hasStopped = false;
  let nextAt = -Infinity;
  let isResting = false;

  return {
    /** Updates the user's body, once per frame; times are seconds. */
    update(body: Body, now: number): void {
      isResting = false;
      const isSame = lastBody !== null && isSameBody(body, lastBody);
      if ((isSame && hasStopped) || now < nextAt) return;
      if (!send(body, isSame)) return;
      // So a late frame does not delay the next pose, and a pause does not cause a burst of poses.
      nextAt = Math.max(nextAt + 1 / RATE, now);
      [lastBody, hasStopped] = [body, isSame];
    },
    /** Sends the pose again for a new user. */
    repeat(): void {
      hasStopped = isResting && lastBody !== null && send(lastBody, true);
    },
    /** Handles a pause of frames, as in a hidden tab: sends a resting pose without a pointer. */
    rest(): void {
      if (!lastBody) return;
      isResting = true;
      lastBody = { ...lastBody, pointer: null };
      hasStopped = send(lastBody, true);
    },
  };
}

function isSameBody(a: Body, b: Body): boolean {
  const parts = ['head', 'left', 'right'] as const;
  return parts.every((part) => isSamePlacement(a[part], b[part])) && isSamePointer(a.pointer, b.pointer);
}

function isSamePlacement(a: Placement | null, b: Placement | null): boolean {
  if (!a || !b) return a === b;
  const isNear = (u: readonly number[], v: readonly number[], tolerance: number): boolean =>
    u.every((value, axis) => Math.abs(value - (v[axis] ?? 0)) <= tolerance);
  return isNear(a.position, b.position, MAX_SHIFT) && isNear(a.rotation, b.rotation, MAX_TURN);
}

function isSamePointer(a: Pointer | null, b: Pointer | null): boolean {
  if (!a || !b) return a === b;
  return a.begin === b.begin && Math.abs(a.length - b.length) <= MAX_LENGTH_CHANGE * b.length;
}
