/** Buffers of numbers that change from picture to picture. */

/** Bytes between two sets of uniforms, because dynamic offsets are aligned. */
export const SLOT = 256;

/** Buffer that grows as needed. */
export class Room {
  #buffer: GPUBuffer | null = null;

  constructor(
    readonly device: GPUDevice,
    readonly label: string,
    readonly usage: GPUBufferUsageFlags,
  ) {}

  /** Returns a buffer of at least this many bytes; growth loses its content. */
  ofSize(bytes: number): GPUBuffer {
    if (this.#buffer && this.#buffer.size >= bytes) return this.#buffer;
    this.#buffer?.destroy();
    const size = Math.max(2 ** Math.ceil(Math.log2(Math.max(bytes, 1))), SLOT);
    const usage = this.usage | GPUBufferUsage.COPY_DST;
    this.#buffer = this.device.createBuffer({ label: this.label, size, usage });
    return this.#buffer;
  }

  /** Returns a buffer that begins with these numbers. */
  with(numbers: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>): GPUBuffer {
    const buffer = this.ofSize(numbers.byteLength);
    this.device.queue.writeBuffer(buffer, 0, numbers);
    return buffer;
  }
}
