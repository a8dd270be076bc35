/** Views, or leaves, on the GPU, those that were used last kept within a number of bytes. */
import { nameOf, type Triple } from '../store/layout';

interface Kept<Layer> {
  readonly level: number;
  readonly place: Triple;
  readonly direction: number;
  readonly layers: readonly Layer[];
  readonly bytes: number;
  /** Number of the picture that showed it last. */
  used: number;
}

/** A view has layers, and a leaf, whose direction is `GEOMETRY`, has pieces. */
export class Resident<Layer extends { readonly bytes: number }> {
  /** In the order of their last use. */
  readonly #views = new Map<string, Kept<Layer>>();
  /** By cell. */
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

  /** Directions of a cell whose views are there, the one that came last at the end. */
  there(level: number, place: Triple): readonly number[] {
    return this.#directions.get(nameOf(level, place)) ?? [];
  }

  /** Begin a picture. */
  begin(): void {
    this.#picture += 1;
  }

  /** The layers of a view for the picture that has begun. */
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

  /** Drop the views that were used the longest ago, none that the picture shows and none that `isKept` names. */
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
