/** Choice of stand-ins for missing views: no hole where a coarser view is loaded. */
import { ancestorOf, type Cells, childrenOf, countOf, type Cut, type Drawn, hasViews } from '../cut/cut';
import { UNBUILT } from '../store/records';
import { type CellKey, nameOf, type Triple, type ViewKey, viewName } from '../store/layout';

/** Number of levels below a cell that are searched for its descendants. */
const MAX_DEPTH = 3;

/** View that is drawn. */
export interface DrawnView extends ViewKey {
  /** Cell for which it stands in, to which drawing is limited; null for no limit. */
  readonly box: CellKey | null;
}

export interface Choice {
  readonly views: readonly DrawnView[];
  /** Leaves whose geometry is drawn, then those whose geometry is missing. */
  readonly leaves: readonly Triple[];
  readonly missingLeaves: readonly Triple[];
  readonly missingViews: readonly ViewKey[];
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
  const drawn: DrawnView[] = [];
  const missingViews: ViewKey[] = [];
  const [leaves, missingLeaves] = [new Map<string, Triple>(), new Map<string, Triple>()];
  let holes = 0;

  const viewsOf = (level: number, place: Triple, box: CellKey | null = null): DrawnView[] =>
    loadedDirections(level, place).map((direction) => ({ level, place, direction, box }));

  /** Whether enough views are loaded to draw a cell; after a turn they may differ from the chosen ones. */
  const isFull = (level: number, place: Triple): boolean => {
    const mask = cells.at(level, place)?.mask ?? 0;
    return hasViews(mask) && loadedDirections(level, place).length >= countOf(mask, { views });
  };

  /** Returns the views of the cells below that cover a cell; null if they do not. */
  function descendantViews(level: number, place: Triple, depth: number): DrawnView[] | null {
    if (level === 0 || depth === 0) return null;
    const covering: DrawnView[] = [];
    for (const child of childrenOf(place)) {
      const cell = cells.at(level - 1, child);
      if (!cell) return null;
      if (cell.mask === 0 || cell.mask === UNBUILT) continue;
      const full = isFull(level - 1, child) ? viewsOf(level - 1, child).slice(-views) : null;
      const childViews = full ?? descendantViews(level - 1, child, depth - 1);
      if (!childViews) return null;
      covering.push(...childViews);
    }
    return covering;
  }

  /** Returns the views of the nearest cell above with any loaded, fully loaded cells first. */
  function ancestorViews(cell: Drawn): DrawnView[] {
    let firstViews: DrawnView[] = [];
    for (let level = cell.level + 1; level < cells.layout.levels; level++) {
      const place = ancestorOf(cell.place, level - cell.level);
      const box = { level: cell.level, place: cell.place };
      if (isFull(level, place)) return viewsOf(level, place, box).slice(-views);
      if (firstViews.length === 0) firstViews = viewsOf(level, place, box);
    }
    return firstViews;
  }

  function show(cell: Drawn, isRequested: boolean): void {
    const { level, place, directions } = cell;
    const loaded = new Set(loadedDirections(level, place));
    const draw = (list: readonly number[]): void => {
      drawn.push(...list.map((direction) => ({ level, place, direction, box: null })));
    };
    const ready = directions.filter((direction) => loaded.has(direction));
    const absent = directions.filter((direction) => !loaded.has(direction));
    if (isRequested) missingViews.push(...absent.map((direction) => ({ level, place, direction })));
    if (absent.length === 0) return draw(ready);
    if (isFull(level, place)) return draw(complete(ready, loaded, directions.length));
    let standIns = descendantViews(level, place, MAX_DEPTH) ?? ancestorViews(cell);
    if (standIns.length === 0) standIns = viewsOf(level, place);
    if (standIns.length === 0) holes += 1;
    drawn.push(...standIns);
  }

  for (const leaf of cut.leaves) {
    const files = [leaf.place, ...cells.guestsOf(leaf.place)];
    const states = files.map(stateOf);
    const isDrawable = !states.includes('undrawable');
    const absent = files.filter((_, n) => states[n] === 'coming');
    if (isDrawable && absent.length === 0) for (const file of files) leaves.set(nameOf(0, file), file);
    else show(leaf, !isDrawable);
    if (isDrawable) for (const file of absent) missingLeaves.set(nameOf(0, file), file);
  }
  for (const cell of cut.cells) show(cell, true);
  const nearLeaves = { leaves: [...leaves.values()], missingLeaves: [...missingLeaves.values()] };
  return { views: unique(drawn), ...nearLeaves, missingViews, holes };
}

/** Completes loaded directions to a count with the latest of the others. */
function complete(ready: readonly number[], loaded: ReadonlySet<number>, count: number): number[] {
  const others = [...loaded].filter((direction) => !ready.includes(direction));
  return [...ready, ...others.slice(others.length - (count - ready.length))];
}

/** Removes duplicates: several cells may have the same cells above them or below. */
function unique(views: readonly DrawnView[]): DrawnView[] {
  const names = ({ box, ...view }: DrawnView) => `${viewName(view)}/${box ? nameOf(box.level, box.place) : ''}`;
  return [...new Map(views.map((view) => [names(view), view])).values()];
}
