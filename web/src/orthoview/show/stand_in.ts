/** Which views a picture is drawn from while others are still missing: never a hole where a coarser view is there. */
import { above, type Cells, childrenOf } from '../cut/cells';
import { countOf, type Cut, type Drawn } from '../cut/cut';
import { nameOf, type Triple } from '../store/layout';
import type { Box } from '../splats/sight';

/** Levels below a cell on which its descendants are looked for. */
const DEEP = 3;

/** A view that is drawn. */
export interface Shown {
  readonly level: number;
  readonly place: Triple;
  readonly direction: number;
  /** The cell for which it stands in, outside of which it is not drawn; null for all of it. */
  readonly box: Box | null;
}

/** A view that is missing. */
export interface Missing {
  readonly level: number;
  readonly place: Triple;
  readonly direction: number;
}

export interface Choice {
  readonly shown: readonly Shown[];
  /** Leaves whose geometry is drawn, and those whose geometry is missing. */
  readonly near: readonly Triple[];
  readonly coming: readonly Triple[];
  readonly missing: readonly Missing[];
  /** Cells of which nothing at all is there. */
  readonly holes: number;
}

/** The directions of a cell whose views are there, the one that came last at the end. */
export type There = (level: number, place: Triple) => readonly number[];

/** Whether a leaf's geometry is there; `never` if it cannot be drawn. */
export type Near = (place: Triple) => 'there' | 'coming' | 'never';

/**
 * Choose for each cell of a cut its own views, else those of the cells below it, else those of a cell above it. So
 * do leaves that are to be geometry, until theirs and that of their guests is there.
 */
export function choose(cut: Cut, cells: Cells, there: There, views: number, near: Near): Choice {
  const shown: Shown[] = [];
  const missing: Missing[] = [];
  const leaves = new Map<string, Triple>();
  const coming = new Map<string, Triple>();
  let holes = 0;

  const all = (level: number, place: Triple, box: Box | null = null): Shown[] =>
    there(level, place).map((direction) => ({ level, place, direction, box }));

  /** Whether as many views are there as a cell is drawn from; after a turn others than those that are wanted. */
  const isFull = (level: number, place: Triple): boolean => {
    const mask = cells.at(level, place)?.mask ?? 0;
    return mask !== 0 && there(level, place).length >= countOf(mask, { views });
  };

  /** The cells below that cover a cell; null if they do not. */
  function below(level: number, place: Triple, depth: number): Shown[] | null {
    if (level === 0 || depth === 0) return null;
    const found: Shown[] = [];
    for (const child of childrenOf(place)) {
      const cell = cells.at(level - 1, child);
      if (!cell) return null;
      if (cell.mask === 0) continue;
      const own = isFull(level - 1, child) ? all(level - 1, child).slice(-views) : below(level - 1, child, depth - 1);
      if (!own) return null;
      found.push(...own);
    }
    return found;
  }

  /** The nearest cell above of which something is there, full ones before others. */
  function standIn(cell: Drawn): Shown[] {
    let some: Shown[] = [];
    for (let level = cell.level + 1; level < cells.layout.levels; level++) {
      const place = above(cell.place, level - cell.level);
      const box = { level: cell.level, place: cell.place };
      if (isFull(level, place)) return all(level, place, box).slice(-views);
      if (some.length === 0) some = all(level, place, box);
    }
    return some;
  }

  function show(cell: Drawn, isWanted: boolean): void {
    const { level, place, directions } = cell;
    const have = new Set(there(level, place));
    const own = directions.filter((direction) => have.has(direction));
    const absent = directions.filter((direction) => isWanted && !have.has(direction));
    missing.push(...absent.map((direction) => ({ level, place, direction })));
    if (own.length === directions.length) {
      shown.push(...own.map((direction) => ({ level, place, direction, box: null })));
      return;
    }
    const instead = isFull(level, place) ? fill(own, have, directions.length) : null;
    if (instead) {
      shown.push(...instead.map((direction) => ({ level, place, direction, box: null })));
      return;
    }
    let found = below(level, place, DEEP) ?? standIn(cell);
    if (found.length === 0) found = all(level, place);
    if (found.length === 0) holes += 1;
    shown.push(...found);
  }

  for (const leaf of cut.leaves) {
    const files = [leaf.place, ...cells.guestsOf(leaf.place)];
    const states = files.map(near);
    const isDrawable = !states.includes('never');
    const absent = files.filter((_, n) => states[n] === 'coming');
    if (isDrawable && absent.length === 0) for (const file of files) leaves.set(nameOf(0, file), file);
    else show(leaf, !isDrawable);
    if (isDrawable) for (const file of absent) coming.set(nameOf(0, file), file);
  }
  for (const cell of cut.cells) show(cell, true);
  return { shown: unique(shown), near: [...leaves.values()], coming: [...coming.values()], missing, holes };
}

/** The wanted directions that are there, and of the others those that came last. */
function fill(own: readonly number[], have: ReadonlySet<number>, count: number): number[] {
  const others = [...have].filter((direction) => !own.includes(direction));
  return [...own, ...others.slice(others.length - (count - own.length))];
}

/** Several cells may have the same cells below them or above. */
function unique(shown: readonly Shown[]): Shown[] {
  const found = new Map<string, Shown>();
  for (const each of shown) {
    const box = each.box ? nameOf(each.box.level, each.box.place) : '';
    found.set(`${nameOf(each.level, each.place)}/${each.direction}/${box}`, each);
  }
  return [...found.values()];
}
