/** Controls by the controllers' sticks: one walks, the other one turns in steps. No WebXR calls. */
import { beyondRest, type Drive, REST } from '../control/drive';

/** Stick position from −1 to 1, to the right and down, as the browser reports it, and whether it is pressed. */
export interface Stick {
  readonly x: number;
  readonly y: number;
  readonly isPressed: boolean;
}

export interface Wish {
  /** Walking input relative to the head's direction. */
  readonly drive: Drive;
  /** Immediate turn to the left, radians. */
  readonly turn: number;
}

/** Angle of a snap turn, radians: smooth turns cause sickness. */
export const SNAP = Math.PI / 6;
/** Dead zone of a stick; deflection that triggers a turn, and below which the next one is armed. */
const REST_SHARE = 0.18;
const [TURNS, REARMS] = [0.7, 0.35] as const;

export interface Steering {
  /** Reads the sticks of the left and the right hand; a hand without a stick leaves its part to the other. */
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
      // A single stick walks only ahead and back.
      const [x, y] = beyondRest(walks === turns ? 0 : walks.x, walks.y, REST_SHARE);
      return { drive: { ...REST, right: x, ahead: 0 - y, isHasty: walks.isPressed }, turn };
    },
  };
}
