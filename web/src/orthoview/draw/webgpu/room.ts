/** Buffers of numbers that change from picture to picture. */

/** Bytes between numbers that calls choose by an offset. */
export const SLOT = 256;

/** A buffer that grows as needed. */
export class Room {
  #buffer: GPUBuffer | null = null;

  constructor(
    readonly device: GPUDevice,
    readonly label: string,
    readonly usage: GPUBufferUsageFlags,
  ) {}

  /** A buffer of at least so many bytes; what it holds is lost when it grows. */
  ofSize(bytes: number): GPUBuffer {
    if (this.#buffer && this.#buffer.size >= bytes) return this.#buffer;
    this.#buffer?.destroy();
    const size = Math.max(2 ** Math.ceil(Math.log2(Math.max(bytes, 1))), SLOT);
    const usage = this.usage | GPUBufferUsage.COPY_DST;
    this.#buffer = this.device.createBuffer({ label: this.label, size, usage });
    return this.#buffer;
  }

  /** A buffer that begins with these numbers. */
  with(numbers: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>): GPUBuffer {
    const buffer = this.ofSize(numbers.byteLength);
    this.device.queue.writeBuffer(buffer, 0, numbers);
    return buffer;
  }
}
