/** Part of a tree that is on the GPU, and pictures of it. */
import type { Camera } from '../cut/camera';
import type { Piece } from '../decode/leaf';
import type { Splats } from '../decode/pack';
import type { Drawer, Drawn, Held, Item } from '../draw/drawer';
import { modelOf } from '../splats/sight';
import { GEOMETRY, type Layout, nameOf, type Triple } from '../store/layout';
import { Resident } from './resident';
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
  draw(choice: Choice, camera: Camera, grid: number, kept: Kept): Drawn;
  /** Bytes on the GPU; number of views. */
  readonly bytes: number;
  readonly views: number;
  readonly isDone: boolean;
  finish(): Promise<void>;
  readonly unhidden: number | null;
}

/** Creates a stock that is limited to this many bytes of views and a quarter as many of geometry. */
export function stockOf<Layer extends Held, Mesh extends Held>(
  layout: Layout,
  drawer: Drawer<Layer, Mesh>,
  bytes: number,
): Stock {
  const views = new Resident<Layer>((layer) => drawer.drop(layer), bytes);
  const leaves = new Resident<Mesh>((mesh) => drawer.dropMesh(mesh), bytes / 4);
  return {
    addView(level, place, direction, layers) {
      const model = modelOf(layout, level, place, direction);
      views.add(
        level,
        place,
        direction,
        layers.map((splats) => drawer.upload(model, splats)),
      );
    },
    addLeaf(place, pieces) {
      leaves.add(
        0,
        place,
        GEOMETRY,
        pieces.map((piece) => drawer.uploadMesh(piece)),
      );
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
