/** Colours of users by number; consecutive numbers have very different colours. */
import { Color } from 'three';

/** Step of hue from one number to the next, in turns: the golden ratio. */
const TURN = 0.618034;
const [SATURATION, LIGHTNESS] = [0.75, 0.6] as const;

export function colorOf(number: number): Color {
  return new Color().setHSL((number * TURN) % 1, SATURATION, LIGHTNESS);
}

/** Colour of a user for style sheets. */
export function cssOf(number: number): string {
  return `#${colorOf(number).getHexString()}`;
}
