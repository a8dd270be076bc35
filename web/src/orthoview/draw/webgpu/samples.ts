/** Storage of a picture's samples, which are drawn in bands of rows if they are too many for one buffer. */
import { GrowingBuffer } from './buffers';
import { COLOR, DEPTH } from './meshes';
import { TILE } from './sample_shaders';

/** Greatest number of bytes for the depths of a band's samples, and for their colours. */
const MAX_BAND_BYTES = 1 << 26;

/** Range of rows of samples. */
export type Band = Readonly<Record<'number' | 'first' | 'rows', number>>;

/** Splits a picture into bands of whole pixels. */
export function bandsOf(device: GPUDevice, width: number, height: number, grid: number): Band[] {
  const { maxStorageBufferBindingSize, maxTextureDimension2D } = device.limits;
  const rows = Math.min(Math.min(maxStorageBufferBindingSize, MAX_BAND_BYTES) / (4 * width), maxTextureDimension2D);
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
export type Targets = Readonly<Record<'color' | 'depth', GPUTexture>>;

export function createSamples(device: GPUDevice) {
  const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC;
  const storage = (label: string): GrowingBuffer => new GrowingBuffer(device, label, usage);
  const [depthBits, colors, tiles] = [storage('depthBits'), storage('colors'), storage('tiles')];
  let targets: Targets | null = null;

  return {
    /** Buffer that begins with the number of splats of unoccluded parts. */
    get counts(): GPUBuffer {
      return tiles.reserve(0);
    },
    /** Buffers for a band of samples. */
    buffers(width: number, rows: number): Record<'depthBits' | 'colors' | 'tiles', GPUBuffer> {
      const bytes = 4 * width * rows;
      const tileBytes = 4 * (1 + tilesOf(width, rows));
      return { depthBits: depthBits.reserve(bytes), colors: colors.reserve(bytes), tiles: tiles.reserve(tileBytes) };
    },
    /** Render targets for bands of at most this many rows; all bands of a picture must use the same targets. */
    targets(width: number, rows: number): Targets {
      if (targets && targets.color.width === width && targets.color.height === rows) return targets;
      targets?.color.destroy();
      targets?.depth.destroy();
      const textureUsage = GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.TEXTURE_BINDING;
      const create = (format: GPUTextureFormat): GPUTexture =>
        device.createTexture({ label: 'samples', size: [width, rows], format, usage: textureUsage });
      targets = { color: create(COLOR), depth: create(DEPTH) };
      return targets;
    },
  };
}
