/** Interpolation of bodies. */
import type { Vector } from '../control/vector';
import type { Body, Placed, Pointer } from './pose';
import { slerp } from './rotation';

/** Interpolates between two bodies; shares beyond 1 extrapolate, except hands and pointers. */
export function between(from: Body, to: Body, share: number): Body {
  const later = share < 0.5 ? from : to;
  const hand = (side: 'left' | 'right'): Placed | null => {
    const [a, b] = [from[side], to[side]];
    return a && b ? placedBetween(a, b, Math.min(share, 1)) : later[side];
  };
  return {
    head: placedBetween(from.head, to.head, share),
    left: hand('left'),
    right: hand('right'),
    pointer: pointerBetween(from.pointer, to.pointer, Math.min(share, 1)),
  };
}

function placedBetween(from: Placed, to: Placed, share: number): Placed {
  const position = from.position.map((value, axis) => value + share * ((to.position[axis] ?? 0) - value));
  return { position: position as unknown as Vector, rotation: slerp(from.rotation, to.rotation, share) };
}

function pointerBetween(from: Pointer | null, to: Pointer | null, share: number): Pointer | null {
  if (from?.begin !== to?.begin || !from || !to) return share < 0.5 ? from : to;
  return { begin: to.begin, length: from.length + share * (to.length - from.length) };
}
