/** Current movement commands of keys, thumbs and sticks, as shares of full speed from −1 to 1. */
export interface Drive {
  /** Steps to the right and ahead. */
  readonly right: number;
  readonly ahead: number;
  /** Turns to the left and up. */
  readonly turn: number;
  readonly look: number;
  /** Whether to run. */
  readonly isHasty: boolean;
}

export const REST: Drive = { right: 0, ahead: 0, turn: 0, look: 0, isHasty: false };

/** Sum of commands, limited to full speed. */
export function together(...wishes: readonly Drive[]): Drive {
  const sum = (part: (wish: Drive) => number): number => wishes.reduce((total, wish) => total + part(wish), 0);
  const [right, ahead] = clampLength(sum((wish) => wish.right), sum((wish) => wish.ahead));
  const [turn, look] = clampLength(sum((wish) => wish.turn), sum((wish) => wish.look));
  return { right, ahead, turn, look, isHasty: wishes.some((wish) => wish.isHasty) };
}

/** Vector limited to length 1. */
export function clampLength(x: number, y: number): readonly [number, number] {
  const length = Math.max(Math.hypot(x, y), 1);
  return [x / length, y / length];
}

/** Stick position with a dead zone around the centre; outside it starts at 0. */
export function beyondRest(x: number, y: number, rest: number): readonly [number, number] {
  const length = Math.hypot(x, y);
  if (!(length > rest)) return [0, 0];
  const share = Math.min((length - rest) / (1 - rest), 1) / length;
  return [x * share, y * share];
}
