/** Cache of views or leaves on the GPU with a limit of bytes; the least recently used are evicted. */
import { nameOf, type Triple } from '../store/layout';

interface Kept<Layer> {
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
  readonly #views = new Map<string, Kept<Layer>>();
  /** Directions by cell name. */
  readonly #directions = new Map<string, number[]>();
  #picture = 0;
  bytes = 0;

  constructor(
    readonly drop: (layer: Layer) => void,
    readonly most: number,
  ) {}

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
