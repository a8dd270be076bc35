/** Resident part of a tree: views and geometry on the GPU, within limits of bytes. Draws pictures of it. */
import type { Camera } from '../cut/camera';
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { Drawer, FrameCounts, GpuResource, Item } from '../draw/drawer';
import { modelOf } from '../draw/projection';
import { GEOMETRY, type Layout, nameOf, type Triple, type ViewKey, viewName } from '../store/layout';
import type { Choice } from './stand_in';

/** Names of cells and leaves that are not evicted although the picture does not show them. */
type RetainedNames = Readonly<Record<'cells' | 'leaves', ReadonlySet<string>>>;

/** Resident part of a tree, for any back end. */
export type ResidentTree = ReturnType<typeof createResidentTree>;

/** Creates the resident part of a tree: at most `maxViewBytes` bytes of views, and a quarter as many of geometry. */
export function createResidentTree<Layer extends GpuResource, Mesh extends GpuResource>(
  layout: Layout,
  drawer: Drawer<Layer, Mesh>,
  maxViewBytes: number,
) {
  const views = new GpuCache<Layer>((layer) => drawer.drop(layer), maxViewBytes);
  const leaves = new GpuCache<Mesh>((mesh) => drawer.meshes.drop(mesh), maxViewBytes / 4);
  return {
    drawer: drawer as Pick<Drawer<Layer, Mesh>, 'isDone' | 'finish' | 'drawnSplats'>,
    addView({ level, place, direction }: ViewKey, layers: readonly Splats[]): void {
      const model = modelOf(layout, level, place, direction);
      views.add(level, place, direction, layers.map((splats) => drawer.upload(model, splats)));
    },
    addLeaf(place: Triple, pieces: readonly Piece[]): void {
      leaves.add(0, place, GEOMETRY, pieces.map((piece) => drawer.meshes.upload(piece)));
    },
    /** Directions of a cell's loaded views, in the order of their arrival. */
    directionsOf: (level: number, place: Triple): readonly number[] => views.directionsOf(level, place),
    hasLeaf: (place: Triple): boolean => leaves.directionsOf(0, place).length > 0,
    draw(choice: Choice, camera: Camera, grid: number, retained: RetainedNames): FrameCounts {
      views.begin();
      leaves.begin();
      const meshes = choice.leaves.flatMap((place) => leaves.use(0, place, GEOMETRY));
      const items = choice.views.flatMap(({ level, place, direction, box }): Item<Layer>[] =>
        views.use(level, place, direction).map((layer) => ({ layer, box })),
      );
      const counts = drawer.draw(meshes, items, camera, grid);
      views.trim((level, place) => retained.cells.has(nameOf(level, place)));
      leaves.trim((level, place) => retained.leaves.has(nameOf(level, place)));
      return counts;
    },
    /** Bytes on the GPU. */
    get bytes(): number {
      return views.bytes + leaves.bytes;
    },
    /** Number of views. */
    get views(): number {
      return views.count;
    },
  };
}

export type Graphics = 'webgl' | 'webgpu';

/** Facts about the last picture of a tree, for the panel and for tests. */
export interface Facts extends FrameCounts {
  /** Numbers of views in the picture, of stand-ins among them, and of outstanding requests. */
  readonly views: number;
  readonly standIns: number;
  readonly waiting: number;
  /** Number of cells for which nothing is loaded. */
  readonly holes: number;
  /** Number of cells in the picture, the largest ones, that an unfinished build has not reached. */
  readonly unbuilt: number;
  /** Splats of unoccluded parts in the last finished picture; null if unknown. */
  readonly drawnSplats: number | null;
  /** Number of leaves drawn as geometry, with their guests. */
  readonly leaves: number;
  /** Bytes, and number of views, on the GPU. */
  readonly bytes: number;
  readonly residentViews: number;
  /** Whether all views of the cut for this camera are loaded. */
  readonly isComplete: boolean;
  readonly graphics: Graphics | null;
}

/** Facts before the first picture. */
export const INITIAL_FACTS: Omit<Facts, 'drawnSplats'> = {
  ...factsOf({ views: [], leaves: [], holes: 0 }, { splats: 0, triangles: 0, calls: 0 }, { bytes: 0, views: 0 }),
  ...{ waiting: 0, unbuilt: 0, isComplete: false, graphics: null },
};

/** Facts of a picture that do not depend on requests. */
export function factsOf(
  { views, leaves, holes }: Pick<Choice, 'views' | 'leaves' | 'holes'>,
  counts: FrameCounts,
  { bytes, views: residentViews }: Pick<ResidentTree, 'bytes' | 'views'>,
) {
  const standIns = views.filter(({ box }) => box !== null).length;
  return { views: views.length, standIns, holes, ...counts, leaves: leaves.length, bytes, residentViews };
}

interface Entry<Layer> extends ViewKey {
  readonly layers: readonly Layer[];
  readonly bytes: number;
  /** Index of the picture that last used it. */
  lastPicture: number;
}

/** Cache of views with their layers, or of leaves with their pieces under the direction `GEOMETRY`. */
export class GpuCache<Layer extends { readonly bytes: number }> {
  /** Entries by the name of the view, least recently used first. */
  readonly #views = new Map<string, Entry<Layer>>();
  /** Directions by cell name. */
  readonly #directions = new Map<string, number[]>();
  #picture = 0;
  bytes = 0;

  constructor(readonly drop: (layer: Layer) => void, readonly maxBytes: number) {}

  get count(): number {
    return this.#views.size;
  }

  add(level: number, place: Triple, direction: number, layers: readonly Layer[]): void {
    const name = viewName({ level, place, direction });
    this.#remove(name);
    const bytes = layers.reduce((sum, layer) => sum + layer.bytes, 0);
    this.#views.set(name, { level, place, direction, layers, bytes, lastPicture: this.#picture });
    this.#directions.set(nameOf(level, place), [...this.directionsOf(level, place), direction]);
    this.bytes += bytes;
  }

  /** Directions of a cell's loaded views, in the order of their arrival. */
  directionsOf(level: number, place: Triple): readonly number[] {
    return this.#directions.get(nameOf(level, place)) ?? [];
  }

  /** Begins a picture. */
  begin(): void {
    this.#picture += 1;
  }

  /** Returns the layers of a view and marks it as used by the current picture. */
  use(level: number, place: Triple, direction: number): readonly Layer[] {
    const name = viewName({ level, place, direction });
    const view = this.#views.get(name);
    if (!view) return [];
    if (view.lastPicture !== this.#picture) {
      view.lastPicture = this.#picture;
      this.#views.delete(name);
      this.#views.set(name, view);
    }
    return view.layers;
  }

  /** Evicts the least recently used views, except views that the picture uses and cells for which `isKept` is true. */
  trim(isKept: (level: number, place: Triple) => boolean): void {
    for (const [name, view] of this.#views) {
      if (this.bytes <= this.maxBytes) break;
      if (view.lastPicture === this.#picture || isKept(view.level, view.place)) continue;
      this.#remove(name);
    }
  }

  #remove(name: string): void {
    const entry = this.#views.get(name);
    if (!entry) return;
    const { level, place, direction, layers, bytes } = entry;
    layers.forEach((layer) => this.drop(layer));
    this.#views.delete(name);
    this.bytes -= bytes;
    const cell = nameOf(level, place);
    const remaining = this.directionsOf(level, place).filter((each) => each !== direction);
    if (remaining.length > 0) this.#directions.set(cell, remaining);
    else this.#directions.delete(cell);
  }
}
