/** Choice of the views to draw; other loaded views stand in for missing ones, so that there are no holes. */
import { ancestorOf, type Cells, childrenOf, countOf, type Cut, type DrawnCell, hasViews } from '../cut/cut';
import { UNBUILT } from '../store/records';
import { type CellKey, nameOf, type Triple, type ViewKey, viewName } from '../store/layout';

/** Number of levels below a cell in which stand-ins are searched. */
const MAX_DEPTH = 3;

/** View to draw. */
export interface DrawnView extends ViewKey {
  /** Cell to which the view is clipped, because it stands in for that cell; null for no clipping. */
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

/** Directions of a cell's loaded views, in the order of their arrival. */
export type LoadedDirections = (level: number, place: Triple) => readonly number[];

/** State of a leaf's geometry. */
export type GeometryState = 'loaded' | 'missing' | 'undrawable';

/**
 * Chooses for each cell of a cut its own views, else views of its descendants, else views of an ancestor. A leaf of the
 * cut that has geometry is drawn from views until its geometry and that of its guests is loaded.
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

  /** Whether enough views of a cell are loaded, of any directions. */
  const hasEnoughViews = (level: number, place: Triple): boolean => {
    const mask = cells.at(level, place)?.mask ?? 0;
    return hasViews(mask) && loadedDirections(level, place).length >= countOf(mask, { views });
  };

  /** Returns views of descendants that cover a whole cell; null if too few are loaded. */
  function descendantViews(level: number, place: Triple, depth: number): DrawnView[] | null {
    if (level === 0 || depth === 0) return null;
    const covering: DrawnView[] = [];
    for (const child of childrenOf(place)) {
      const cell = cells.at(level - 1, child);
      if (!cell) return null;
      if (cell.mask === 0 || cell.mask === UNBUILT) continue;
      const ownViews = hasEnoughViews(level - 1, child) ? viewsOf(level - 1, child).slice(-views) : null;
      const childViews = ownViews ?? descendantViews(level - 1, child, depth - 1);
      if (!childViews) return null;
      covering.push(...childViews);
    }
    return covering;
  }

  /** Returns the views of the nearest ancestor with enough views, else of the nearest one with any. */
  function ancestorViews(cell: DrawnCell): DrawnView[] {
    let firstViews: DrawnView[] = [];
    for (let level = cell.level + 1; level < cells.layout.levels; level++) {
      const place = ancestorOf(cell.place, level - cell.level);
      const box = { level: cell.level, place: cell.place };
      if (hasEnoughViews(level, place)) return viewsOf(level, place, box).slice(-views);
      if (firstViews.length === 0) firstViews = viewsOf(level, place, box);
    }
    return firstViews;
  }

  /** Adds the views to draw for a cell, and the missing ones if they are to be requested. */
  function addViews(cell: DrawnCell, isRequested: boolean): void {
    const { level, place, directions } = cell;
    const loaded = new Set(loadedDirections(level, place));
    const draw = (chosen: readonly number[]): void => {
      drawn.push(...chosen.map((direction) => ({ level, place, direction, box: null })));
    };
    const ready = directions.filter((direction) => loaded.has(direction));
    const absent = directions.filter((direction) => !loaded.has(direction));
    if (isRequested) missingViews.push(...absent.map((direction) => ({ level, place, direction })));
    if (absent.length === 0) return draw(ready);
    if (hasEnoughViews(level, place)) return draw(complete(ready, loaded, directions.length));
    let standIns = descendantViews(level, place, MAX_DEPTH) ?? ancestorViews(cell);
    if (standIns.length === 0) standIns = viewsOf(level, place);
    if (standIns.length === 0) holes += 1;
    drawn.push(...standIns);
  }

  for (const leaf of cut.leaves) {
    const files = [leaf.place, ...cells.leavesReachingInto(leaf.place)];
    const states = files.map(stateOf);
    const isDrawable = !states.includes('undrawable');
    const absent = files.filter((_, n) => states[n] === 'missing');
    if (isDrawable && absent.length === 0) for (const file of files) leaves.set(nameOf(0, file), file);
    else addViews(leaf, !isDrawable);
    if (isDrawable) for (const file of absent) missingLeaves.set(nameOf(0, file), file);
  }
  for (const cell of cut.cells) addViews(cell, true);
  const nearLeaves = { leaves: [...leaves.values()], missingLeaves: [...missingLeaves.values()] };
  return { views: removeDuplicates(drawn), ...nearLeaves, missingViews, holes };
}

/** Adds the most recently loaded other directions, so that there are `count`. */
function complete(ready: readonly number[], loaded: ReadonlySet<number>, count: number): number[] {
  const others = [...loaded].filter((direction) => !ready.includes(direction));
  return [...ready, ...others.slice(others.length - (count - ready.length))];
}

/** Removes duplicate views, because several cells may have the same stand-ins. */
function removeDuplicates(views: readonly DrawnView[]): DrawnView[] {
  const nameOfView = ({ box, ...view }: DrawnView): string =>
    `${viewName(view)}/${box ? nameOf(box.level, box.place) : ''}`;
  return [...new Map(views.map((view) => [nameOfView(view), view])).values()];
}
