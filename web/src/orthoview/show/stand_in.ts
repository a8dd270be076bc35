/** Choice of stand-ins for missing views: no hole where a coarser view is loaded. */
import { ancestorOf, type Cells, childrenOf, countOf, type Cut, type Drawn } from '../cut/cut';
import { type CellKey, nameOf, type Triple, type ViewKey, viewName } from '../store/layout';

/** Number of levels below a cell that are searched for its descendants. */
const MAX_DEPTH = 3;

/** View that is drawn. */
export interface Shown extends ViewKey {
  /** Cell for which it stands in, to which drawing is limited; null for no limit. */
  readonly box: CellKey | null;
}

export interface Choice {
  readonly shown: readonly Shown[];
  /** Leaves whose geometry is drawn, then those whose geometry is missing. */
  readonly near: readonly Triple[];
  readonly coming: readonly Triple[];
  readonly missing: readonly ViewKey[];
  /** Number of cells for which nothing is loaded. */
  readonly holes: number;
}

/** Directions of a cell's loaded views, the latest one last. */
export type LoadedDirections = (level: number, place: Triple) => readonly number[];

/** State of a leaf's geometry. */
export type GeometryState = 'loaded' | 'coming' | 'undrawable';

/**
 * Chooses for each cell of a cut its own views, or the views of cells below it, or of a cell above it. A leaf that is
 * to be drawn as geometry is drawn from views, too, until its geometry and that of its guests is loaded.
 */
export function choose(
  cut: Cut,
  cells: Cells,
  loadedDirections: LoadedDirections,
  views: number,
  stateOf: (leaf: Triple) => GeometryState,
): Choice {
  const shown: Shown[] = [];
  const missing: ViewKey[] = [];
  const leaves = new Map<string, Triple>();
  const coming = new Map<string, Triple>();
  let holes = 0;

  const all = (level: number, place: Triple, box: CellKey | null = null): Shown[] =>
    loadedDirections(level, place).map((direction) => ({ level, place, direction, box }));

  /** Whether enough views are loaded to draw a cell; after a turn they may differ from the chosen ones. */
  const isFull = (level: number, place: Triple): boolean => {
    const mask = cells.at(level, place)?.mask ?? 0;
    return mask !== 0 && loadedDirections(level, place).length >= countOf(mask, { views });
  };

  /** Returns the views of the cells below that cover a cell; null if they do not. */
  function below(level: number, place: Triple, depth: number): Shown[] | null {
    if (level === 0 || depth === 0) return null;
    const covering: Shown[] = [];
    for (const child of childrenOf(place)) {
      const cell = cells.at(level - 1, child);
      if (!cell) return null;
      if (cell.mask === 0) continue;
      const full = isFull(level - 1, child) ? all(level - 1, child).slice(-views) : null;
      const childViews = full ?? below(level - 1, child, depth - 1);
      if (!childViews) return null;
      covering.push(...childViews);
    }
    return covering;
  }

  /** Returns the views of the nearest cell above with any loaded, fully loaded cells first. */
  function standIn(cell: Drawn): Shown[] {
    let firstViews: Shown[] = [];
    for (let level = cell.level + 1; level < cells.layout.levels; level++) {
      const place = ancestorOf(cell.place, level - cell.level);
      const box = { level: cell.level, place: cell.place };
      if (isFull(level, place)) return all(level, place, box).slice(-views);
      if (firstViews.length === 0) firstViews = all(level, place, box);
    }
    return firstViews;
  }

  function show(cell: Drawn, isRequested: boolean): void {
    const { level, place, directions } = cell;
    const loaded = new Set(loadedDirections(level, place));
    const draw = (list: readonly number[]): void => {
      shown.push(...list.map((direction) => ({ level, place, direction, box: null })));
    };
    const ready = directions.filter((direction) => loaded.has(direction));
    const absent = directions.filter((direction) => !loaded.has(direction));
    if (isRequested) missing.push(...absent.map((direction) => ({ level, place, direction })));
    if (absent.length === 0) return draw(ready);
    if (isFull(level, place)) return draw(complete(ready, loaded, directions.length));
    let standIns = below(level, place, MAX_DEPTH) ?? standIn(cell);
    if (standIns.length === 0) standIns = all(level, place);
    if (standIns.length === 0) holes += 1;
    shown.push(...standIns);
  }

  for (const leaf of cut.leaves) {
    const files = [leaf.place, ...cells.guestsOf(leaf.place)];
    const states = files.map(stateOf);
    const isDrawable = !states.includes('undrawable');
    const absent = files.filter((_, n) => states[n] === 'coming');
    if (isDrawable && absent.length === 0) for (const file of files) leaves.set(nameOf(0, file), file);
    else show(leaf, !isDrawable);
    if (isDrawable) for (const file of absent) coming.set(nameOf(0, file), file);
  }
  for (const cell of cut.cells) show(cell, true);
  return { shown: unique(shown), near: [...leaves.values()], coming: [...coming.values()], missing, holes };
}

/** Completes loaded directions to a count with the latest of the others. */
function complete(ready: readonly number[], loaded: ReadonlySet<number>, count: number): number[] {
  const others = [...loaded].filter((direction) => !ready.includes(direction));
  return [...ready, ...others.slice(others.length - (count - ready.length))];
}

/** Removes duplicates: several cells may have the same cells above them or below. */
function unique(shown: readonly Shown[]): Shown[] {
  const names = ({ box, ...view }: Shown) => `${viewName(view)}/${box ? nameOf(box.level, box.place) : ''}`;
  return [...new Map(shown.map((view) => [names(view), view])).values()];
}
