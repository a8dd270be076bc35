/** Sticks of gamepads: the left one walks, the right one looks; pressing the left one or its shoulder button runs. */
import { beyondRest, type Drive, REST, together } from './drive';

/** The part of a stick's way in which it counts as at rest: worn sticks do not come back to 0. */
const REST_SHARE = 0.18;
/** Numbers of buttons in the standard layout: left shoulder, left stick. */
const HASTE = [4, 10] as const;

/** The part of the browser's Gamepad that is read. */
export interface Pad {
  readonly connected: boolean;
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

/** Requests of all gamepads. Those whose layout is unknown are left alone. */
export function readPads(pads: readonly (Pad | null)[]): Drive {
  const known = pads.filter((pad) => pad !== null && pad.connected && pad.mapping === 'standard');
  return known.length === 0 ? REST : together(...known.map((pad) => (pad ? wishOf(pad) : REST)));
}

function wishOf({ axes, buttons }: Pad): Drive {
  const [right, back] = beyondRest(axes[0] ?? 0, axes[1] ?? 0, REST_SHARE);
  const [clockwise, down] = beyondRest(axes[2] ?? 0, axes[3] ?? 0, REST_SHARE);
  const isHasty = HASTE.some((number) => buttons[number]?.pressed ?? false);
  // Sums from 0, so that a stick at rest gives 0 and not −0.
  return { right, ahead: 0 - back, turn: 0 - clockwise, look: 0 - down, isHasty };
}
