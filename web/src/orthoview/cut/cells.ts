/** Occupied cells of a tree, from the subtrees known so far. */
import { type Layout, nameOf, shardSide, subtreeOf, type Triple } from '../store/layout';
import type { Subtree } from '../store/records';

/** Children of a cell, one level below. */
export function childrenOf([x, y, z]: Triple): Triple[] {
  return Array.from({ length: 8 }, (_, n) => [2 * x + (n >> 2), 2 * y + ((n >> 1) & 1), 2 * z + (n & 1)] as const);
}

/** Ancestor of a cell, some levels above it. */
export function ancestorOf([x, y, z]: Triple, levels: number): Triple {
  const side = 2 ** levels;
  return [Math.floor(x / side), Math.floor(y / side), Math.floor(z / side)];
}

export interface Cell {
  /** Bit mask of the directions with non-empty views; 0 for an empty cell. */
  readonly mask: number;
  /** Number of the generation in which the cell was computed. */
  readonly generation: number;
}

const EMPTY: Cell = { mask: 0, generation: 0 };

export class Cells {
  readonly #subtrees = new Map<string, Subtree>();

  constructor(readonly layout: Layout) {}

  add(subtree: Subtree): void {
    this.#subtrees.set(nameOf(subtree.tier, subtree.place), subtree);
  }

  knows(tier: number, place: Triple): boolean {
    return this.#subtrees.has(nameOf(tier, place));
  }

  /** Other leaves that own triangles which reach into a leaf. */
  guestsOf(leaf: Triple): readonly Triple[] {
    const { tier, place } = subtreeOf(this.layout, 0, leaf);
    return this.#subtrees.get(nameOf(tier, place))?.guests.get(nameOf(0, leaf)) ?? [];
  }

  /** A cell; null if its subtree has not been added. */
  at(level: number, place: Triple): Cell | null {
    const { tier, place: subtreePlace } = subtreeOf(this.layout, level, place);
    const subtree = this.#subtrees.get(nameOf(tier, subtreePlace));
    if (!subtree) return null;
    const side = shardSide(this.layout, level);
    const [x, y, z] = place;
    const index = ((x % side) * side + (y % side)) * side + (z % side);
    const levelInTier = level % this.layout.subtree;
    const [mask, generation] = [subtree.masks[levelInTier]?.[index], subtree.generations[levelInTier]?.[index]];
    return mask === undefined || generation === undefined ? EMPTY : { mask, generation };
  }
}
