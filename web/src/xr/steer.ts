/** Sticks of the controllers: one walks, the other one turns in steps; plain arithmetic without a headset. */
import { beyondRest, type Drive, REST } from '../control/drive';

/** A stick from −1 to 1, to the right and down, as the browser gives it, and whether it is pressed. */
export interface Stick {
  readonly x: number;
  readonly y: number;
  readonly isPressed: boolean;
}

export interface Wish {
  /** Steps, which way the head looks. */
  readonly drive: Drive;
  /** Radians to turn left at once. */
  readonly turn: number;
}

/** A turn at once, radians: smooth turns make people sick. */
export const SNAP = Math.PI / 6;
/** The part of a stick's way in which it counts as at rest; where a turn begins, and where the next one may. */
const REST_SHARE = 0.18;
const [TURNS, REARMS] = [0.7, 0.35] as const;

export interface Steering {
  /** The wishes of the sticks of the left and the right hand; a hand without a stick leaves its part to the other. */
  read(left: Stick | null, right: Stick | null): Wish;
}

export function createSteering(): Steering {
  let isArmed = true;

  function snap(x: number): number {
    if (Math.abs(x) < REARMS) isArmed = true;
    if (!isArmed || Math.abs(x) < TURNS) return 0;
    isArmed = false;
    return -Math.sign(x) * SNAP;
  }

  return {
    read(left, right) {
      const walks = left ?? right;
      const turns = right ?? left;
      const turn = snap(turns?.x ?? 0);
      if (!walks) return { drive: REST, turn };
      // One stick for both walks only ahead and back.
      const [x, y] = beyondRest(walks === turns ? 0 : walks.x, walks.y, REST_SHARE);
      return { drive: { ...REST, right: x, ahead: 0 - y, isHasty: walks.isPressed }, turn };
    },
  };
}
