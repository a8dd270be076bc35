/** Reading and writing of little-endian numbers. */

/** Error for malformed bytes, with a sentence. */
export class FrameError extends Error {}

/** Reader of numbers that throws an error at the end of the bytes. */
export class Reader {
  private at = 0;
  private readonly view: DataView;

  constructor(private readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get isAtEnd(): boolean {
    return this.at === this.bytes.length;
  }

  u8(): number {
    return this.view.getUint8(this.step(1));
  }

  u16(): number {
    return this.view.getUint16(this.step(2), true);
  }

  i16(): number {
    return this.view.getInt16(this.step(2), true);
  }

  u32(): number {
    return this.view.getUint32(this.step(4), true);
  }

  u64(): bigint {
    return this.view.getBigUint64(this.step(8), true);
  }

  f32(): number {
    return this.view.getFloat32(this.step(4), true);
  }

  /** Returns the next bytes, without copying them. */
  take(count: number): Uint8Array {
    const begin = this.step(count);
    return this.bytes.subarray(begin, begin + count);
  }

  /** Returns all remaining bytes. */
  rest(most: number): Uint8Array {
    const count = this.bytes.length - this.at;
    if (count > most) throw new FrameError('a payload is too long');
    return this.take(count);
  }

  /** Throws an error if bytes remain. */
  end(sentence = 'a frame is too long'): void {
    if (!this.isAtEnd) throw new FrameError(sentence);
  }

  private step(count: number): number {
    const begin = this.at;
    if (begin + count > this.bytes.length) throw new FrameError('a frame is too short');
    this.at = begin + count;
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
    this.add(2);
  }

  i16(value: number): void {
    this.view.setInt16(0, value, true);
    this.add(2);
  }

  u32(value: number): void {
    this.view.setUint32(0, value, true);
    this.add(4);
  }

  u64(value: bigint): void {
    this.view.setBigUint64(0, value, true);
    this.add(8);
  }

  f32(value: number): void {
    this.view.setFloat32(0, value, true);
    this.add(4);
  }

  put(bytes: Uint8Array): void {
    this.bytes.push(...bytes);
  }

  done(): Uint8Array<ArrayBuffer> {
    return Uint8Array.from(this.bytes);
  }

  private add(count: number): void {
    for (let index = 0; index < count; index++) this.bytes.push(this.view.getUint8(index));
  }
}

/** Decodes UTF-8; throws an error with a sentence for anything else. */
export function textOf(bytes: Uint8Array, sentence: string): string {
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    throw new FrameError(sentence);
  }
}
