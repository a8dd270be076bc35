/** The cells of a tree in which something is, by the subtrees that are known so far. */
import { type Layout, nameOf, shardSide, subtreeOf, type Triple } from '../store/layout';
import type { Subtree } from '../store/records';

/** The children of a cell, one level below. */
export function childrenOf([x, y, z]: Triple): Triple[] {
  return Array.from({ length: 8 }, (_, n) => [2 * x + (n >> 2), 2 * y + ((n >> 1) & 1), 2 * z + (n & 1)] as const);
}

/** The cell that holds another one, some levels above it. */
export function above([x, y, z]: Triple, levels: number): Triple {
  const side = 2 ** levels;
  return [Math.floor(x / side), Math.floor(y / side), Math.floor(z / side)];
}

export interface Cell {
  /** Bits of the directions from which it shows something; 0 for a cell in which nothing is. */
  readonly mask: number;
  /** Number of the generation in which it was computed. */
  readonly generation: number;
}

const NOTHING: Cell = { mask: 0, generation: 0 };

export class Cells {
  readonly #subtrees = new Map<string, Subtree>();

  constructor(readonly layout: Layout) {}

  add(subtree: Subtree): void {
    this.#subtrees.set(nameOf(subtree.tier, subtree.place), subtree);
  }

  knows(tier: number, place: Triple): boolean {
    return this.#subtrees.has(nameOf(tier, place));
  }

  /** The other leaves to which triangles belong that reach into a leaf. */
  guestsOf(leaf: Triple): readonly Triple[] {
    const { tier, place } = subtreeOf(this.layout, 0, leaf);
    return this.#subtrees.get(nameOf(tier, place))?.guests.get(nameOf(0, leaf)) ?? [];
  }

  /** The directions of a cell; null if its subtree has not been added. */
  at(level: number, place: Triple): Cell | null {
    const { tier, place: own } = subtreeOf(this.layout, level, place);
    const subtree = this.#subtrees.get(nameOf(tier, own));
    if (!subtree) return null;
    const side = shardSide(this.layout, level);
    const [x, y, z] = place.map((number, axis) => number - (own[axis] as number) * side) as [number, number, number];
    const at = (x * side + y) * side + z;
    const number = level % this.layout.subtree;
    const [mask, generation] = [subtree.masks[number]?.[at], subtree.generations[number]?.[at]];
    return mask === undefined || generation === undefined ? NOTHING : { mask, generation };
  }
}
