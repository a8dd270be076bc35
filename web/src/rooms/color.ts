/** Colours of users by their numbers; neighbouring numbers have colours that differ much. */
import { Color } from 'three';

/** Turns of the colour circle from one number to the next: the golden ratio. */
const TURN = 0.618034;
const [SATURATION, LIGHTNESS] = [0.75, 0.6] as const;

export function colorOf(number: number): Color {
  return new Color().setHSL((number * TURN) % 1, SATURATION, LIGHTNESS);
}

/** The same for style sheets. */
export function cssOf(number: number): string {
  return `#${colorOf(number).getHexString()}`;
}
