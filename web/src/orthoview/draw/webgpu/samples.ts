/** Storage of a picture's samples: for all of them at once, or for bands of rows if they are too many. */
import { GrowingBuffer } from './buffers';
import { COLOR, DEPTH } from './meshes';
import { TILE } from './sample_shaders';

/** Greatest number of bytes for the depths of a band's samples, and for their colours. */
const MAX = 1 << 26;

/** Range of rows of samples. */
export interface Band {
  readonly number: number;
  readonly first: number;
  readonly rows: number;
}

/** Splits a picture into bands of whole pixels. */
export function bandsOf(device: GPUDevice, width: number, height: number, grid: number): Band[] {
  const { maxStorageBufferBindingSize, maxTextureDimension2D } = device.limits;
  const rows = Math.min(Math.min(maxStorageBufferBindingSize, MAX) / (4 * width), maxTextureDimension2D);
  const rowsPerBand = Math.max(Math.floor(rows / grid), 1) * grid;
  return Array.from({ length: Math.ceil(height / rowsPerBand) }, (_, n) => ({
    number: n,
    first: n * rowsPerBand,
    rows: Math.min(rowsPerBand, height - n * rowsPerBand),
  }));
}

/** Number of tiles that cover the samples. */
export function tilesOf(width: number, rows: number): number {
  return Math.ceil(width / TILE) * Math.ceil(rows / TILE);
}

/** Render targets of the geometry. */
export interface Targets {
  readonly color: GPUTexture;
  readonly depth: GPUTexture;
}

export class Samples {
  readonly #orders: GrowingBuffer;
  readonly #colors: GrowingBuffer;
  readonly #tiles: GrowingBuffer;
  #targets: Targets | null = null;

  constructor(readonly device: GPUDevice) {
    const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC;
    const storage = (label: string): GrowingBuffer => new GrowingBuffer(device, label, usage);
    [this.#orders, this.#colors, this.#tiles] = [storage('orders'), storage('colors'), storage('tiles')];
  }

  /** Buffer that begins with the number of splats of unoccluded parts. */
  get counts(): GPUBuffer {
    return this.#tiles.ofSize(0);
  }

  /** Buffers for a band of samples. */
  buffers(width: number, rows: number): { orders: GPUBuffer; colors: GPUBuffer; tiles: GPUBuffer } {
    const bytes = 4 * width * rows;
    const tiles = this.#tiles.ofSize(4 * (1 + tilesOf(width, rows)));
    return { orders: this.#orders.ofSize(bytes), colors: this.#colors.ofSize(bytes), tiles };
  }

  /** Render targets for all bands of at most this many rows: a picture's commands must not replace them. */
  targets(width: number, rows: number): Targets {
    const targets = this.#targets;
    if (targets && targets.color.width === width && targets.color.height === rows) return targets;
    targets?.color.destroy();
    targets?.depth.destroy();
    const usage = GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.TEXTURE_BINDING;
    const create = (format: GPUTextureFormat): GPUTexture =>
      this.device.createTexture({ label: 'samples', size: [width, rows], format, usage });
    this.#targets = { color: create(COLOR), depth: create(DEPTH) };
    return this.#targets;
  }
}
