/** Reading and writing of little-endian numbers. */

/** Error for malformed bytes; its message is a sentence. */
export class FrameError extends Error {}

/** Reader of numbers that throws an error at the end of the bytes. */
export class Reader {
  private offset = 0;
  private readonly view: DataView;

  constructor(private readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get isAtEnd(): boolean {
    return this.offset === this.bytes.length;
  }

  u8(): number {
    return this.view.getUint8(this.advance(1));
  }

  u16(): number {
    return this.view.getUint16(this.advance(2), true);
  }

  i16(): number {
    return this.view.getInt16(this.advance(2), true);
  }

  u32(): number {
    return this.view.getUint32(this.advance(4), true);
  }

  u64(): bigint {
    return this.view.getBigUint64(this.advance(8), true);
  }

  f32(): number {
    return this.view.getFloat32(this.advance(4), true);
  }

  /** Returns the next bytes, without copying them. */
  take(count: number): Uint8Array {
    const begin = this.advance(count);
    return this.bytes.subarray(begin, begin + count);
  }

  /** Returns all remaining bytes; throws an error if there are more than `maxLength`. */
  takeRest(maxLength: number): Uint8Array {
    const count = this.bytes.length - this.offset;
    if (count > maxLength) throw new FrameError('a payload is too long');
    return this.take(count);
  }

  /** Throws an error if bytes remain. */
  expectEnd(sentence = 'a frame is too long'): void {
    if (!this.isAtEnd) throw new FrameError(sentence);
  }

  private advance(count: number): number {
    const begin = this.offset;
    if (begin + count > this.bytes.length) throw new FrameError('a frame is too short');
    this.offset = begin + count;
    return begin;
  }
}

/** Writer of numbers into a growing array. */
export class Writer {
  private readonly bytes: number[] = [];
  private readonly view = new DataView(new ArrayBuffer(8));

  get length(): number {
    return this.bytes.length;
  }

  u8(value: number): void {
    this.bytes.push(value & 0xff);
  }

  u16(value: number): void {
    this.view.setUint16(0, value, true);
    this.flush(2);
  }

  i16(value: number): void {
    this.view.setInt16(0, value, true);
    this.flush(2);
  }

  u32(value: number): void {
    this.view.setUint32(0, value, true);
    this.flush(4);
  }

  u64(value: bigint): void {
    this.view.setBigUint64(0, value, true);
    this.flush(8);
  }

  f32(value: number): void {
    this.view.setFloat32(0, value, true);
    this.flush(4);
  }

  put(bytes: Uint8Array): void {
    this.bytes.push(...bytes);
  }

  toBytes(): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(this.bytes);
  }

  private flush(count: number): void {
    for (let index = 0; index < count; index++) this.bytes.push(this.view.getUint8(index));
  }
}

/** Decodes UTF-8; throws an error with the given sentence if the bytes are not UTF-8. */
export function textOf(bytes: Uint8Array, sentence: string): string {
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    throw new FrameError(sentence);
  }
}
