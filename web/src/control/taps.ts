/** Distinguishes double taps from dragging. */

/** Greatest milliseconds of a tap, and between two taps; greatest movement in pixels meanwhile. */
const [LONGEST, PAUSE, STILL] = [300, 400, 16] as const;

type Event = Pick<PointerEvent, 'pointerId' | 'clientX' | 'clientY' | 'timeStamp'>;

export interface Taps {
  down(event: Event): void;
  up(event: Event): void;
}

/** `twice` receives the second tap. */
export function createTaps(twice: (event: Event) => void): Taps {
  const downs = new Map<number, Event>();
  let last: Event | null = null;

  const isNear = (a: Event, b: Event): boolean => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) <= STILL;

  return {
    down(event) {
      // Two simultaneous fingers are no tap.
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
