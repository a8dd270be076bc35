/** The numbers of a picture's calls, as shaders read them. */
import type { Projector } from '../../splats/sight';
import { SLOT } from './room';
import type { Band } from './samples';

/** Numbers that are the same for all calls. */
export interface Common {
  /** Of the samples. */
  readonly projector: Projector;
  readonly grid: number;
  /** Metres at which depths end. */
  readonly nearest: number;
  /** Number of all parts. */
  readonly parts: number;
}

export interface Called {
  /** Parts [first, first + count). */
  readonly first?: number;
  readonly count?: number;
  readonly round?: number;
  /** Number of the page. */
  readonly page?: number;
}

export class Numbers {
  readonly #data: ArrayBuffer;
  #used = 0;

  constructor(
    readonly common: Common,
    /** Calls, at most. */
    calls: number,
  ) {
    this.#data = new ArrayBuffer(SLOT * calls);
  }

  get all(): Uint32Array<ArrayBuffer> {
    return new Uint32Array(this.#data);
  }

  /** Add a call; returns where its numbers lie. */
  put(band: Band, { first = 0, count = 0, round = 0, page = 0 }: Called): number {
    const { projector, grid, nearest, parts } = this.common;
    const at = SLOT * this.#used;
    const floats = new Float32Array(this.#data, at, SLOT / 4);
    [...projector.rows, ...projector.rays].forEach((vector, n) => floats.set(vector, 4 * n));
    new Uint32Array(this.#data, at + 96, 12).set([
      ...[projector.width, band.rows, band.first, grid],
      ...[first, count, round, 0],
      ...[parts, page, 0, 0],
    ]);
    floats[36] = nearest;
    this.#used += 1;
    return at;
  }
}
