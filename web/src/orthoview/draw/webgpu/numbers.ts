/** Uniforms of a picture's calls in the layout of the shaders. */
import type { Projector } from '../../splats/sight';
import { SLOT } from './room';
import type { Band } from './samples';

/** Uniforms that are the same for all calls. */
export interface Common {
  /** Projector of the samples. */
  readonly projector: Projector;
  readonly grid: number;
  /** Least distance in metres; depths are relative to it. */
  readonly nearest: number;
  /** Number of all parts. */
  readonly parts: number;
}

export interface Called {
  /** First part of the range [first, first + count). */
  readonly first?: number;
  readonly count?: number;
  readonly round?: number;
  /** Index of the page. */
  readonly page?: number;
}

export class Numbers {
  readonly #data: ArrayBuffer;
  #used = 0;

  constructor(
    readonly common: Common,
    /** Greatest number of calls. */
    calls: number,
  ) {
    this.#data = new ArrayBuffer(SLOT * calls);
  }

  get all(): Uint32Array<ArrayBuffer> {
    return new Uint32Array(this.#data);
  }

  /** Adds a call; returns the byte offset of its uniforms. */
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
