/** Tells two taps of a finger at one place from dragging. */

/** Milliseconds of a tap, and from one to the next; pixels by which pointers move meanwhile. */
const [LONGEST, PAUSE, STILL] = [300, 400, 16] as const;

type Event = Pick<PointerEvent, 'pointerId' | 'clientX' | 'clientY' | 'timeStamp'>;

export interface Taps {
  down(event: Event): void;
  up(event: Event): void;
}

/** `twice` is told of the place of the second tap. */
export function createTaps(twice: (event: Event) => void): Taps {
  const downs = new Map<number, Event>();
  let last: Event | null = null;

  const isNear = (a: Event, b: Event): boolean => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) <= STILL;

  return {
    down(event) {
      // Of two fingers at once neither taps.
      if (downs.size > 0) last = null;
      downs.set(event.pointerId, event);
    },
    up(event) {
      const begun = downs.get(event.pointerId);
      const isAlone = downs.size === 1;
      downs.delete(event.pointerId);
      const isTap = begun && isAlone && event.timeStamp - begun.timeStamp <= LONGEST && isNear(begun, event);
      if (!isTap) {
        last = null;
        return;
      }
      const isSecond = last !== null && event.timeStamp - last.timeStamp <= PAUSE && isNear(last, event);
      last = isSecond ? null : event;
      if (isSecond) twice(event);
    },
  };
}
