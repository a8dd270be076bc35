/** Part of a tree that is on the GPU, within limits of bytes, and pictures of it. */
import type { Camera } from '../cut/camera';
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { Drawer, FrameCounts, GpuResource, Item } from '../draw/drawer';
import { modelOf } from '../draw/sight';
import { GEOMETRY, type Layout, nameOf, type Triple } from '../store/layout';
import type { Choice } from './stand_in';

/** Cells and leaves that are evicted last although the picture does not show them. */
export interface Kept {
  /** Names of cells. */
  readonly cells: ReadonlySet<string>;
  readonly leaves: ReadonlySet<string>;
}

/** Views and geometry on the GPU, independent of the back end. */
export interface Stock {
  addView(level: number, place: Triple, direction: number, layers: readonly Splats[]): void;
  addLeaf(place: Triple, pieces: readonly Piece[]): void;
  /** Directions of a cell's loaded views, the latest one last. */
  there(level: number, place: Triple): readonly number[];
  /** Whether a leaf's geometry is loaded. */
  hasLeaf(place: Triple): boolean;
  draw(choice: Choice, camera: Camera, grid: number, kept: Kept): FrameCounts;
  /** Bytes on the GPU; number of views. */
  readonly bytes: number;
  readonly views: number;
  readonly isDone: boolean;
  finish(): Promise<void>;
  readonly unhidden: number | null;
}

/** Creates a stock that is limited to this many bytes of views and a quarter as many of geometry. */
export function stockOf<Layer extends GpuResource, Mesh extends GpuResource>(
  layout: Layout,
  drawer: Drawer<Layer, Mesh>,
  bytes: number,
): Stock {
  const views = new Resident<Layer>((layer) => drawer.drop(layer), bytes);
  const leaves = new Resident<Mesh>((mesh) => drawer.dropMesh(mesh), bytes / 4);
  return {
    addView(level, place, direction, layers) {
      const model = modelOf(layout, level, place, direction);
      views.add(level, place, direction, layers.map((splats) => drawer.upload(model, splats)));
    },
    addLeaf(place, pieces) {
      leaves.add(0, place, GEOMETRY, pieces.map((piece) => drawer.uploadMesh(piece)));
    },
    there: (level, place) => views.there(level, place),
    hasLeaf: (place) => leaves.there(0, place).length > 0,
    draw({ near, shown }, camera, grid, kept) {
      views.begin();
      leaves.begin();
      const meshes = near.flatMap((place) => leaves.use(0, place, GEOMETRY));
      const items = shown.flatMap(({ level, place, direction, box }): Item<Layer>[] =>
        views.use(level, place, direction).map((layer) => ({ layer, box })),
      );
      const drawn = drawer.draw(meshes, items, camera, grid);
      views.trim((level, place) => kept.cells.has(nameOf(level, place)));
      leaves.trim((level, place) => kept.leaves.has(nameOf(level, place)));
      return drawn;
    },
    get bytes() {
      return views.bytes + leaves.bytes;
    },
    get views() {
      return views.count;
    },
    get isDone() {
      return drawer.isDone;
    },
    finish: () => drawer.finish(),
    get unhidden() {
      return drawer.unhidden;
    },
  };
}

interface Entry<Layer> {
  readonly level: number;
  readonly place: Triple;
  readonly direction: number;
  readonly layers: readonly Layer[];
  readonly bytes: number;
  /** Index of the picture that last used it. */
  used: number;
}

/** Cache of views, which have layers, or of leaves, which have direction `GEOMETRY` and pieces. */
export class Resident<Layer extends { readonly bytes: number }> {
  /** Views by name, least recently used first. */
  readonly #views = new Map<string, Entry<Layer>>();
  /** Directions by cell name. */
  readonly #directions = new Map<string, number[]>();
  #picture = 0;
  bytes = 0;

  constructor(readonly drop: (layer: Layer) => void, readonly most: number) {}

  get count(): number {
    return this.#views.size;
  }

  add(level: number, place: Triple, direction: number, layers: readonly Layer[]): void {
    const name = `${nameOf(level, place)}/${direction}`;
    this.#remove(name);
    const bytes = layers.reduce((sum, layer) => sum + layer.bytes, 0);
    this.#views.set(name, { level, place, direction, layers, bytes, used: this.#picture });
    this.#directions.set(nameOf(level, place), [...this.there(level, place), direction]);
    this.bytes += bytes;
  }

  /** Directions of a cell's loaded views, the latest one last. */
  there(level: number, place: Triple): readonly number[] {
    return this.#directions.get(nameOf(level, place)) ?? [];
  }

  /** Begins a picture. */
  begin(): void {
    this.#picture += 1;
  }

  /** Returns the layers of a view and marks it as used by the current picture. */
  use(level: number, place: Triple, direction: number): readonly Layer[] {
    const name = `${nameOf(level, place)}/${direction}`;
    const view = this.#views.get(name);
    if (!view) return [];
    if (view.used !== this.#picture) {
      view.used = this.#picture;
      this.#views.delete(name);
      this.#views.set(name, view);
    }
    return view.layers;
  }

  /** Evicts least recently used views, except those that the picture uses or `isKept` selects. */
  trim(isKept: (level: number, place: Triple) => boolean): void {
    for (const [name, view] of this.#views) {
      if (this.bytes <= this.most) break;
      if (view.used === this.#picture || isKept(view.level, view.place)) continue;
      this.#remove(name);
    }
  }

  #remove(name: string): void {
    const found = this.#views.get(name);
    if (!found) return;
    const { level, place, direction, layers, bytes } = found;
    layers.forEach((layer) => this.drop(layer));
    this.#views.delete(name);
    this.bytes -= bytes;
    const cell = nameOf(level, place);
    const left = this.there(level, place).filter((each) => each !== direction);
    if (left.length > 0) this.#directions.set(cell, left);
    else this.#directions.delete(cell);
  }
}
