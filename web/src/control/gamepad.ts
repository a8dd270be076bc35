/** Gamepad sticks: the left one walks, the right one looks; pressing the left one or its shoulder button runs. */
import { beyondRest, type Drive, REST, together } from './drive';

/** Dead zone as a share of a stick's range: worn sticks do not return to 0. */
const REST_SHARE = 0.18;
/** Button numbers in the standard layout: left shoulder, left stick. */
const HASTE = [4, 10] as const;

/** Subset of the browser's Gamepad. */
export interface Pad {
  readonly connected: boolean;
  readonly mapping: string;
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean }[];
}

/** Commands of all gamepads with the standard layout. */
export function readPads(pads: readonly (Pad | null)[]): Drive {
  const known = pads.filter((pad) => pad !== null && pad.connected && pad.mapping === 'standard');
  return known.length === 0 ? REST : together(...known.map((pad) => (pad ? wishOf(pad) : REST)));
}

function wishOf({ axes, buttons }: Pad): Drive {
  const [right, back] = beyondRest(axes[0] ?? 0, axes[1] ?? 0, REST_SHARE);
  const [clockwise, down] = beyondRest(axes[2] ?? 0, axes[3] ?? 0, REST_SHARE);
  const isHasty = HASTE.some((number) => buttons[number]?.pressed ?? false);
  // Subtracted from 0, so that a stick at rest gives 0 instead of −0.
  return { right, ahead: 0 - back, turn: 0 - clockwise, look: 0 - down, isHasty };
}
