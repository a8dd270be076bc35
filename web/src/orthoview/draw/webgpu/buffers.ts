/**
 * Growing buffers for data that change with each picture, and an arena that packs the data of many views into a few
 * large buffers ("pages"), so that one draw call draws all views of a page.
 */
import type { GpuResource } from '../drawer';

/** Bytes between two sets of uniforms: the alignment of dynamic offsets. */
export const UNIFORM_STRIDE = 256;
/** Minimum size of a growing buffer, bytes. */
const MIN_BYTES = 256;

/** Buffer that grows as needed. */
export class GrowingBuffer {
  #buffer: GPUBuffer | null = null;

  constructor(readonly device: GPUDevice, readonly label: string, readonly usage: GPUBufferUsageFlags) {}

  /** Returns a buffer of at least this many bytes; if the buffer grows, its content is lost. */
  reserve(bytes: number): GPUBuffer {
    if (this.#buffer && this.#buffer.size >= bytes) return this.#buffer;
    this.#buffer?.destroy();
    const size = Math.max(2 ** Math.ceil(Math.log2(Math.max(bytes, 1))), MIN_BYTES);
    const usage = this.usage | GPUBufferUsage.COPY_DST;
    this.#buffer = this.device.createBuffer({ label: this.label, size, usage });
    return this.#buffer;
  }

  /** Returns a buffer that begins with these numbers. */
  write(numbers: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>): GPUBuffer {
    const buffer = this.reserve(numbers.byteLength);
    this.device.queue.writeBuffer(buffer, 0, numbers);
    return buffer;
  }
}

/** Minimum number of 32-bit words in a page, 32 MiB. */
const MIN_PAGE_WORDS = 1 << 23;
/** Alignment of all ranges, words. */
const ALIGNMENT_WORDS = 64;

/** Range of words in a page. */
export interface PageRange extends GpuResource {
  readonly page: Page;
  readonly first: number;
  readonly words: number;
}

type Gap = Record<'first' | 'words', number>;

export interface Page {
  readonly buffer: GPUBuffer;
  readonly words: number;
  /** Free ranges of words, sorted by position. */
  readonly gaps: Gap[];
}

/** Allocates ranges of words in pages. */
export class Arena {
  readonly #pages: Page[] = [];

  constructor(readonly device: GPUDevice) {}

  /** Uploads words to the GPU. */
  put(words: Uint32Array<ArrayBuffer>): PageRange {
    const wordCount = Math.max(Math.ceil(words.length / ALIGNMENT_WORDS), 1) * ALIGNMENT_WORDS;
    const { page, gap } = this.#find(wordCount) ?? this.#grow(wordCount);
    const range: PageRange = { page, first: gap.first, words: wordCount, bytes: 4 * wordCount };
    gap.first += wordCount;
    gap.words -= wordCount;
    if (gap.words === 0) page.gaps.splice(page.gaps.indexOf(gap), 1);
    this.device.queue.writeBuffer(page.buffer, 4 * range.first, words);
    return range;
  }

  free({ page, first, words }: PageRange): void {
    const { gaps } = page;
    const next = gaps.findIndex((gap) => gap.first > first);
    const index = next < 0 ? gaps.length : next;
    gaps.splice(index, 0, { first, words });
    this.#join(gaps, index);
    this.#join(gaps, index - 1);
    if (gaps[0]?.words !== page.words) return;
    // WebGPU frees the buffer only after the submitted pictures that use it are drawn.
    page.buffer.destroy();
    this.#pages.splice(this.#pages.indexOf(page), 1);
  }

  /** Merges a gap with the next one if they touch. */
  #join(gaps: Gap[], at: number): void {
    const [gap, next] = [gaps[at], gaps[at + 1]];
    if (!gap || !next || gap.first + gap.words !== next.first) return;
    gap.words += next.words;
    gaps.splice(at + 1, 1);
  }

  #find(words: number): { page: Page; gap: Gap } | null {
    for (const page of this.#pages) {
      const gap = page.gaps.find((each) => each.words >= words);
      if (gap) return { page, gap };
    }
    return null;
  }

  #grow(words: number): { page: Page; gap: Gap } {
    const { maxBufferSize, maxStorageBufferBindingSize } = this.device.limits;
    const maxBytes = Math.min(maxBufferSize, maxStorageBufferBindingSize);
    const maxWords = Math.floor(maxBytes / 4 / ALIGNMENT_WORDS) * ALIGNMENT_WORDS;
    if (words > maxWords) throw new Error(`a view of ${4 * words} bytes is larger than the graphics device allows`);
    const size = Math.min(Math.max(words, MIN_PAGE_WORDS), maxWords);
    const usage = GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST;
    const buffer = this.device.createBuffer({ label: 'page of views', size: 4 * size, usage });
    const gap = { first: 0, words: size };
    const page = { buffer, words: size, gaps: [gap] };
    this.#pages.push(page);
    return { page, gap };
  }
}
