/** Rate control of a user's poses: as often as others can use them, and only while something changes. */
import type { Body, Placed, Pointer } from './pose';

/** Poses per second. */
const RATE = 72;
/** Tolerances of "no change": metres; component of a rotation; relative change of a pointer's length. */
const [MAX_SHIFT, MAX_TURN, MAX_LENGTH_CHANGE] = [1e-3, 5e-4, 1e-3] as const;

/** Creates a sender; `send` sends a pose, the last one before a rest if `stops`, and returns whether it was sent. */
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
      // A late frame does not delay the next one, and a pause does not cause a burst.
      nextAt = Math.max(nextAt + 1 / RATE, now);
      [lastBody, hasStopped] = [body, isSame];
    },
    /** Sends the pose again for a new user. */
    repeat(): void {
      hasStopped = isResting && lastBody !== null && send(lastBody, true);
    },
    /** Handles a pause of frames, as in a hidden tab: the user rests and its pointer is hidden. */
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
  return parts.every((part) => isSamePlaced(a[part], b[part])) && isSamePointer(a.pointer, b.pointer);
}

function isSamePlaced(a: Placed | null, b: Placed | null): boolean {
  if (!a || !b) return a === b;
  const isNear = (u: readonly number[], v: readonly number[], tolerance: number): boolean =>
    u.every((value, axis) => Math.abs(value - (v[axis] ?? 0)) <= tolerance);
  return isNear(a.position, b.position, MAX_SHIFT) && isNear(a.rotation, b.rotation, MAX_TURN);
}

function isSamePointer(a: Pointer | null, b: Pointer | null): boolean {
  if (!a || !b) return a === b;
  return a.begin === b.begin && Math.abs(a.length - b.length) <= MAX_LENGTH_CHANGE * b.length;
}
