/** Cuts through the octree: the cells, levels and directions that a viewer needs, and the messages of their worker. */
import type { Failure } from '../store/error';
import { cornerOf, type Layout, sideAt, subtreeOf, type Triple } from '../store/layout';
import type { Shard, Subtree } from '../store/records';
import { type Camera, dot, frameOf, frustumOf, pixelSize, type Side, sideOf, unit, widest } from './camera';
import { type Cells, childrenOf } from './cells';

export interface Settings {
  /** Number of views of a cell: those whose directions are nearest to the viewer's. */
  readonly views: number;
  /** Greatest width of a view's pixels, in pixels of the picture. */
  readonly error: number;
  /** Whether cells outside of the picture count, too. */
  readonly isAround: boolean;
  /** Whether leaves that are too near for their views are drawn as geometry, if the tree has it. */
  readonly geometry: boolean;
  /** Degrees by which the viewer's direction is raised before a cell's views are chosen. */
  readonly lift: number;
}

/** A drawn cell. */
export interface Drawn {
  readonly level: number;
  readonly place: Triple;
  /** Distance of its nearest point, metres. */
  readonly distance: number;
  readonly isInPicture: boolean;
  /** Numbers of its directions, the nearest one first. */
  readonly directions: readonly number[];
}

export interface Cut {
  /** Drawn cells, the nearest ones first. */
  readonly cells: readonly Drawn[];
  /** Leaves drawn as geometry, the nearest ones first; their views are shown until it has arrived. */
  readonly leaves: readonly Drawn[];
  /** Distance from which leaves are fine enough, metres; cells of level k from 2ᵏ times as far. */
  readonly reach: number;
  /** Unknown subtrees, in whose place coarser cells are drawn. */
  readonly unknown: readonly { readonly tier: number; readonly place: Triple }[];
}

/** Cuts a tree for a viewer, with the known subtrees. */
export function cut(cells: Cells, camera: Camera, settings: Settings): Cut {
  const { layout } = cells;
  const pitch = (layout.cell * widest(layout.directions)) / layout.size;
  const reach = pitch / (pixelSize(camera) * settings.error);
  const planes = frustumOf(camera);
  const units = layout.directions.map((direction) => frameOf(direction).axes[2]);
  const raise = liftOf(settings.lift);
  const [drawn, leaves]: [Drawn[], Drawn[]] = [[], []];
  const hasGeometry = settings.geometry && layout.geometry;
  const unknown = new Map<string, { tier: number; place: Triple }>();

  function visit(level: number, place: Triple, mask: number, above: Side): void {
    const side = sideAt(layout, level);
    const corner = cornerOf(layout, level, place);
    const center: Triple = [corner[0] + side / 2, corner[1] + side / 2, corner[2] + side / 2];
    const lies = above === 'across' ? sideOf(planes, center, side) : above;
    if (mask === 0 || (lies === 'outside' && !settings.isAround)) return;
    const distance = distanceOf(camera.position, corner, side);
    const found = { level, place, distance, isInPicture: lies !== 'outside' };
    const draw = (list: Drawn[]): void => {
      const toward = towardOf(camera.position, center);
      list.push({ ...found, directions: nearest(units, raise(toward), toward, mask, settings.views) });
    };
    if (distance >= reach * 2 ** level) draw(drawn);
    else if (level === 0 && hasGeometry) {
      draw(leaves);
      requireGuests(place);
    } else if (level === 0) draw(drawn);
    else if (!refine(level - 1, place, lies)) draw(drawn);
  }

  /** Requires the records of a leaf's guests, which locate their geometry. */
  function requireGuests(leaf: Triple): void {
    for (const guest of cells.guestsOf(leaf)) {
      const { tier, place } = subtreeOf(layout, 0, guest);
      if (!cells.knows(tier, place)) addUnknown(0, guest);
    }
  }

  /** Visits the children of a cell; false if they are unknown. */
  function refine(level: number, parent: Triple, lies: Side): boolean {
    const children = childrenOf(parent).map((place) => ({ place, cell: cells.at(level, place) }));
    for (const { place, cell } of children) {
      if (cell) continue;
      // All children of a cell lie in one subtree.
      addUnknown(level, place);
      return false;
    }
    for (const { place, cell } of children) if (cell) visit(level, place, cell.mask, lies);
    return true;
  }

  function addUnknown(level: number, place: Triple): void {
    const found = subtreeOf(layout, level, place);
    unknown.set(`${found.tier}/${found.place}`, found);
  }

  const top = layout.levels - 1;
  const root = cells.at(top, [0, 0, 0]);
  if (root) visit(top, [0, 0, 0], root.mask, 'across');
  else addUnknown(top, [0, 0, 0]);
  for (const list of [drawn, leaves]) list.sort((a, b) => a.distance - b.distance);
  return { cells: drawn, leaves, reach, unknown: [...unknown.values()] };
}

/** Distance of a cube's nearest point. */
function distanceOf(eye: Triple, corner: Triple, side: number): number {
  const along = eye.map((at, axis) => {
    const low = corner[axis] as number;
    return at - Math.min(Math.max(at, low), low + side);
  }) as unknown as Triple;
  return Math.sqrt(dot(along, along));
}

/** Direction from a cell's centre to the viewer. */
function towardOf(eye: Triple, center: Triple): Triple {
  return unit([eye[0] - center[0], eye[1] - center[1], eye[2] - center[2]]);
}

/**
 * Directions of a mask that are nearest to the raised direction. Equally high directions are equally near to the
 * zenith; then those nearest to the viewer's own direction count; of equally near ones the first.
 */
function nearest(units: readonly Triple[], raised: Triple, toward: Triple, mask: number, most: number): number[] {
  const shown = units.map((axis, number) => ({ number, cosine: dot(axis, raised), own: dot(axis, toward) }))
    .filter(({ number }) => (mask >>> number) & 1);
  return shown.sort((a, b) => b.cosine - a.cosine || b.own - a.own).slice(0, most).map(({ number }) => number);
}

/** Number of views of a non-empty cell: the requested number, if available. */
export function countOf(mask: number, { views }: Pick<Settings, 'views'>): number {
  let [count, left] = [0, mask];
  for (; left !== 0; left &= left - 1) count += 1;
  return Math.min(count, views);
}

/** Sine of the angle from straight down within which a direction cannot be raised to a side. */
const STRAIGHT = 1e-9;

/** Function that rotates unit vectors by an angle in degrees towards +y, at most to +y. Straight down stays. */
export function liftOf(degrees: number): (way: Triple) => Triple {
  const angle = (degrees * Math.PI) / 180;
  const [sine, cosine] = [Math.sin(angle), Math.cos(angle)];
  return (way) => {
    const [x, y, z] = way;
    const flat = Math.hypot(x, z);
    if (sine === 0 || (flat < STRAIGHT && y < 0)) return way;
    const across = flat * cosine - y * sine;
    if (across <= 0) return [0, 1, 0];
    return [(x / flat) * across, y * cosine + flat * sine, (z / flat) * across];
  };
}

export type ToCutter =
  | { readonly kind: 'open'; readonly base: string }
  /** Sets the camera: the cut is sent at once, and again whenever more of the tree is known. */
  | { readonly kind: 'look'; readonly camera: Camera; readonly settings: Settings }
  /** Retries failed reads. */
  | { readonly kind: 'retry' };

export type FromCutter =
  | {
      readonly kind: 'opened';
      readonly layout: Layout;
      readonly generation: number;
      readonly shards: readonly Shard[];
      readonly geometry: readonly Shard[];
    }
  | { readonly kind: 'learned'; readonly subtree: Subtree }
  | { readonly kind: 'cut'; readonly cut: Cut }
  /** Coarse cells all around the viewer, which are few: shown first when a viewer turns. */
  | { readonly kind: 'base'; readonly cut: Cut }
  | { readonly kind: 'received'; readonly bytes: number }
  /** `isFatal` if nothing can be shown. */
  | { readonly kind: 'failed'; readonly failure: Failure; readonly isFatal: boolean };
