/** Shards and geometry files listed by the records that have been read, and requests for views. */
import type { Cells } from '../cut/cut';
import type { ViewRequest } from '../decode/reader';
import { GEOMETRY, geometryPaths, type Layout, shardPaths, type Triple, type ViewKey } from '../store/layout';
import type { Shard } from '../store/records';

/** Path prefix of the files of a generation after the first. */
const GENERATION = /^nearfar\/generations\/\d+\//;

export class Catalog {
  readonly #shards = new Map<string, Shard>();
  /** Newest geometry files by their paths below a generation's folder. */
  readonly #files = new Map<string, Shard>();

  /** Adds listed shards and geometry files, which replace no file of the same name: add newer generations first. */
  add(shards: readonly Shard[], geometry: readonly Shard[]): void {
    for (const shard of shards) this.#shards.set(shard[0], shard);
    for (const file of geometry) {
      const name = file[0].replace(GENERATION, '');
      if (!this.#files.has(name)) this.#files.set(name, file);
    }
  }

  /** Files of a leaf's geometry, if it has any. */
  filesOf(layout: Layout, leaf: Triple): Shard[] {
    const files = geometryPaths(layout, leaf).map((name) => this.#files.get(name));
    return files.filter((file) => file !== undefined && file[1] > 0) as Shard[];
  }

  /** Request for a view or, with the direction `GEOMETRY`, for a leaf's geometry. */
  request(cells: Cells, view: ViewKey): ViewRequest {
    const { layout } = cells;
    const { level, place, direction } = view;
    if (direction === GEOMETRY) return { ...view, generation: 0, shards: this.filesOf(layout, place) };
    const generation = cells.at(level, place)?.generation ?? 0;
    const shards = shardPaths(layout, view, generation).map((path) => this.#shards.get(path));
    return { ...view, generation, shards: shards.filter((shard) => shard !== undefined) };
  }
}
