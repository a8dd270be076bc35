/** Cuts of the octree: the cells and directions to draw for a camera; messages of the worker that makes cuts. */
import type { Failure } from '../store/error';
import type { CellKey, Layout, Triple } from '../store/layout';
import { cornerOf, nameOf, shardSide, sideAt, subtreeOf } from '../store/layout';
import { PARTIAL, type Records, type Subtree, UNBUILT } from '../store/records';
import type { Camera, Containment } from './camera';
import { containmentOf, dot, frameOf, frustumOf, pixelSize, subtract, unit, maxExtent } from './camera';

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
  /** Bit mask of the directions with non-empty views; 0 for an empty cell, or `UNBUILT` or `PARTIAL`. */
  readonly mask: number;
  /** Generation in which the cell was computed. */
  readonly generation: number;
}

const EMPTY: Cell = { mask: 0, generation: 0 };

/** Occupied cells of a tree, as far as its subtrees have been loaded. */
export class Cells {
  readonly #subtrees = new Map<string, Subtree>();

  constructor(readonly layout: Layout) {}

  add(subtree: Subtree): void {
    this.#subtrees.set(nameOf(subtree.tier, subtree.place), subtree);
  }

  knows(tier: number, place: Triple): boolean {
    return this.#subtrees.has(nameOf(tier, place));
  }

  /** Guests of a leaf: other leaves whose triangles extend into it. */
  leavesReachingInto(leaf: Triple): readonly Triple[] {
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

export interface Settings {
  /** Number of views drawn of a cell: those with the directions nearest to the viewer's. */
  readonly views: number;
  /** Greatest width of a view's pixels, in pixels of the picture. */
  readonly error: number;
  /** Whether the cut has cells outside the picture, too. */
  readonly includesOutside: boolean;
  /** Whether leaves that are too near for their views are drawn as geometry, if the tree has geometry. */
  readonly geometry: boolean;
  /** Degrees by which the viewer's direction is raised before a cell's views are chosen. */
  readonly raiseDegrees: number;
}

/** A drawn cell. */
export interface DrawnCell extends CellKey {
  /** Distance from the camera to the cell's nearest point, metres. */
  readonly distance: number;
  readonly isInPicture: boolean;
  /** Directions of the views to draw, nearest to the viewer's first. */
  readonly directions: readonly number[];
}

export interface Cut {
  /** Drawn cells, nearest first. */
  readonly cells: readonly DrawnCell[];
  /** Leaves drawn as geometry, nearest first; until it has arrived, their views are drawn. */
  readonly leaves: readonly DrawnCell[];
  /** Distance from which views of leaves are fine enough, metres; for level k it is 2ᵏ times as great. */
  readonly leafDistance: number;
  /** Subtrees that are not loaded; coarser cells are drawn instead. */
  readonly unknown: readonly { readonly tier: number; readonly place: Triple }[];
  /** Number of cells, the largest ones, that an unfinished build has not reached. */
  readonly unbuilt: number;
}

/** Cuts a tree for a camera, as far as its subtrees are loaded. */
export function cut(cells: Cells, camera: Camera, settings: Settings): Cut {
  const { layout } = cells;
  const pitch = (layout.cell * maxExtent(layout.directions)) / layout.size;
  const leafDistance = pitch / (pixelSize(camera) * settings.error);
  const planes = frustumOf(camera);
  const viewAxes = layout.directions.map((direction) => frameOf(direction).axes[2]);
  const raise = liftOf(settings.raiseDegrees);
  const [drawnCells, leaves]: [DrawnCell[], DrawnCell[]] = [[], []];
  const hasGeometry = settings.geometry && layout.geometry;
  const unknown = new Map<string, { tier: number; place: Triple }>();
  let unbuilt = 0;

  function visit(level: number, place: Triple, mask: number, parentContainment: Containment): void {
    const side = sideAt(layout, level);
    const corner = cornerOf(layout, level, place);
    const center: Triple = [corner[0] + side / 2, corner[1] + side / 2, corner[2] + side / 2];
    const containment = parentContainment === 'across' ? containmentOf(planes, center, side) : parentContainment;
    if (mask === 0 || (containment === 'outside' && !settings.includesOutside)) return;
    if (!hasViews(mask)) {
      if (mask === PARTIAL && level > 0) refine(level - 1, place, containment);
      else unbuilt += 1;
      return;
    }
    const distance = distanceOf(camera.position, corner, side);
    const draw = (list: DrawnCell[]): void => {
      const toViewer = unit(subtract(camera.position, center));
      const directions = nearestDirections(viewAxes, raise(toViewer), toViewer, mask, settings.views);
      list.push({ level, place, distance, isInPicture: containment !== 'outside', directions });
    };
    const isFine = distance >= leafDistance * 2 ** level;
    if (!isFine && level === 0 && hasGeometry) {
      draw(leaves);
      // The records of guests state where their geometry is stored.
      for (const guest of cells.leavesReachingInto(place)) {
        const subtree = subtreeOf(layout, 0, guest);
        if (!cells.knows(subtree.tier, subtree.place)) addUnknown(0, guest);
      }
    } else if (isFine || level === 0 || !refine(level - 1, place, containment)) draw(drawnCells);
  }

  /** Visits the children of a cell; returns false if their subtree is not loaded. */
  function refine(level: number, parent: Triple, containment: Containment): boolean {
    const children = childrenOf(parent).map((place) => ({ place, cell: cells.at(level, place) }));
    // All children of a cell lie in one subtree.
    const unknownChild = children.find(({ cell }) => !cell);
    if (unknownChild) addUnknown(level, unknownChild.place);
    else for (const { place, cell } of children) visit(level, place, cell?.mask ?? 0, containment);
    return !unknownChild;
  }

  function addUnknown(level: number, place: Triple): void {
    const subtree = subtreeOf(layout, level, place);
    unknown.set(`${subtree.tier}/${subtree.place}`, subtree);
  }

  const top = layout.levels - 1;
  const root = cells.at(top, [0, 0, 0]);
  if (root) visit(top, [0, 0, 0], root.mask, 'across');
  else addUnknown(top, [0, 0, 0]);
  for (const list of [drawnCells, leaves]) list.sort((a, b) => a.distance - b.distance);
  return { cells: drawnCells, leaves, leafDistance, unknown: [...unknown.values()], unbuilt };
}

/** Distance from the eye to a cube's nearest point, metres. */
function distanceOf(eye: Triple, corner: Triple, side: number): number {
  const offset = eye.map((coordinate, axis) => {
    const low = corner[axis] as number;
    return coordinate - Math.min(Math.max(coordinate, low), low + side);
  }) as unknown as Triple;
  return Math.sqrt(dot(offset, offset));
}

/**
 * The `count` directions of a mask that are nearest to `raised`, nearest first. Of equally near directions, those
 * nearer to `toViewer` come first, then those with lower numbers.
 */
function nearestDirections(units: readonly Triple[], raised: Triple, toViewer: Triple, mask: number, count: number) {
  return units.map((axis, number) => ({ number, cosine: dot(axis, raised), unraised: dot(axis, toViewer) }))
    .filter(({ number }) => (mask >>> number) & 1)
    .sort((a, b) => b.cosine - a.cosine || b.unraised - a.unraised)
    .slice(0, count)
    .map(({ number }) => number);
}

/** Whether a cell of a mask has views, that is, is built and not empty. */
export function hasViews(mask: number): boolean {
  return mask !== 0 && mask !== UNBUILT && mask !== PARTIAL;
}

/** Number of views to draw of a cell with views: the requested number, or all if there are fewer. */
export function countOf(mask: number, { views }: Pick<Settings, 'views'>): number {
  let count = 0;
  for (let bits = mask; bits !== 0; bits &= bits - 1) count += 1;
  return Math.min(count, views);
}

/** Least horizontal length of a unit vector from which its horizontal direction is computed. */
const MIN_HORIZONTAL = 1e-9;

/** Creates a function that rotates unit vectors towards +y, but not beyond it; straight down stays. */
export function liftOf(degrees: number): (direction: Triple) => Triple {
  const angle = (degrees * Math.PI) / 180;
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return (direction) => {
    const [x, y, z] = direction;
    const horizontal = Math.hypot(x, z);
    if (sine === 0 || (horizontal < MIN_HORIZONTAL && y < 0)) return direction;
    const raised = horizontal * cosine - y * sine;
    if (raised <= 0) return [0, 1, 0];
    return [(x / horizontal) * raised, y * cosine + horizontal * sine, (z / horizontal) * raised];
  };
}

export type ToCutter =
  | { readonly kind: 'open'; readonly base: string }
  /** Sets the camera: the worker sends a cut at once, and again whenever a subtree is loaded. */
  | { readonly kind: 'look'; readonly camera: Camera; readonly settings: Settings }
  /** Retries failed reads. */
  | { readonly kind: 'retry' };

/** Records of an opened store that the viewer needs. */
export type OpenedStore = Pick<Records, 'layout' | 'shards' | 'geometry'>;

export type FromCutter =
  | ({ readonly kind: 'opened' } & OpenedStore)
  | { readonly kind: 'subtree'; readonly subtree: Subtree }
  /** `coarse` has the few coarse cells all around the viewer, which are shown first when the viewer turns. */
  | { readonly kind: 'cut'; readonly cut: Cut; readonly coarse: Cut }
  | { readonly kind: 'received'; readonly bytes: number }
  /** `isFatal` if nothing can be shown. */
  | { readonly kind: 'failed'; readonly failure: Failure; readonly isFatal: boolean };
