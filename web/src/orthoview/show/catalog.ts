/** Shards and geometry files listed by the records that have been read, and requests for views. */
import type { Cells } from '../cut/cut';
import type { ViewRequest } from '../decode/reader';
import {
  cellInShard,
  GEOMETRY,
  geometryPaths,
  type Layout,
  shardPath,
  type Triple,
  type ViewKey,
} from '../store/layout';
import type { Shard, StoredFile } from '../store/records';

/** Path prefix of the files of a generation after the first. */
const GENERATION = /^nearfar\/generations\/\d+\//;

export class Catalog {
  readonly #shards = new Map<string, Shard>();
  /** Newest geometry files by their paths below a generation's folder. */
  readonly #files = new Map<string, StoredFile>();

  /** Adds listed shards and geometry files, which replace no file of the same name: add newer generations first. */
  add(shards: readonly Shard[], geometry: readonly StoredFile[]): void {
    for (const shard of shards) this.#shards.set(shard.file[0], shard);
    for (const file of geometry) {
      const name = file[0].replace(GENERATION, '');
      if (!this.#files.has(name)) this.#files.set(name, file);
    }
  }

  /** Files of a leaf's geometry, if it has any. */
  filesOf(layout: Layout, leaf: Triple): StoredFile[] {
    const files = geometryPaths(layout, leaf).map((name) => this.#files.get(name));
    return files.filter((file) => file !== undefined && file[1] > 0) as StoredFile[];
  }

  /** Request for a view or, with the direction `GEOMETRY`, for a leaf's geometry. */
  request(cells: Cells, view: ViewKey): ViewRequest {
    const { layout } = cells;
    const { level, place, direction } = view;
    if (direction === GEOMETRY) return { ...view, generation: 0, files: this.filesOf(layout, place) };
    const generation = cells.at(level, place)?.generation ?? 0;
    const shard = this.#shards.get(shardPath(layout, view, generation));
    const index = shard?.cells.indexOf(cellInShard(layout, level, place)) ?? -1;
    if (!shard || index < 0) return { ...view, generation, files: [] };
    const first = index === 0 ? 0 : (shard.ends[index - 1] as number);
    return { ...view, generation, files: [shard.file], part: [first, (shard.ends[index] as number) - first] };
  }
}
