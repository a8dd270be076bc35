/** Codecs for binary messages: little-endian numbers, bytes, and records. A codec both reads and writes. */
import { concatBytes } from '../base/bytes';

/** Error for malformed bytes; its message is shown to users. */
export class FrameError extends Error {}

export interface Codec<Value> {
  /** Reads a value; throws `FrameError` for invalid bytes. */
  read(from: Reader): Value;
  write(out: Writer, value: Value): void;
}

/** Type of the values that a codec encodes. */
export type ValueOf<Encoding> = Encoding extends Codec<infer Value> ? Value : never;

/** Reader of bytes; throws an error if there are too few. */
export class Reader {
  private offset = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get remaining(): number {
    return this.bytes.length - this.offset;
  }

  /** Returns the next bytes, without copying them. */
  take(count: number): Uint8Array {
    if (count > this.remaining) throw new FrameError('a frame is too short');
    this.offset += count;
    return this.bytes.subarray(this.offset - count, this.offset);
  }

  expectEnd(errorMessage = 'a frame is too long'): void {
    if (this.remaining > 0) throw new FrameError(errorMessage);
  }
}

/** Collects bytes, which `toBytes` copies. */
export class Writer {
  private readonly parts: Uint8Array[] = [];

  put(bytes: Uint8Array): void {
    this.parts.push(bytes);
  }

  toBytes(): Uint8Array<ArrayBuffer> {
    return concatBytes(this.parts);
  }
}

/** Encodes a value as bytes. */
export function encode<Value>(codec: Codec<Value>, value: Value): Uint8Array<ArrayBuffer> {
  const out = new Writer();
  codec.write(out, value);
  return out.toBytes();
}

/** Decodes a value from all bytes; throws an error with `errorMessage` if some remain. */
export function decode<Value>(codec: Codec<Value>, bytes: Uint8Array, errorMessage?: string): Value {
  const reader = new Reader(bytes);
  const value = codec.read(reader);
  reader.expectEnd(errorMessage);
  return value;
}

export const U8 = numberCodec<number>(1, 'Uint8');
export const U16 = numberCodec<number>(2, 'Uint16');
export const I16 = numberCodec<number>(2, 'Int16');
export const U32 = numberCodec<number>(4, 'Uint32');
export const U64 = numberCodec<bigint>(8, 'BigUint64');
export const F32 = numberCodec<number>(4, 'Float32');

/** Codec of little-endian numbers, by the accessors of `DataView` for a kind. */
function numberCodec<Value extends number | bigint>(
  size: number,
  kind: 'Uint8' | 'Uint16' | 'Int16' | 'Uint32' | 'BigUint64' | 'Float32',
): Codec<Value> {
  type Accessors = Record<string, (offset: number, ...args: (Value | boolean)[]) => Value>;
  const accessors = (bytes: Uint8Array): Accessors =>
    new DataView(bytes.buffer, bytes.byteOffset, size) as unknown as Accessors;
  return {
    read: (from) => accessors(from.take(size))[`get${kind}`]?.(0, true) as Value,
    write(out, value) {
      const bytes = new Uint8Array(size);
      accessors(bytes)[`set${kind}`]?.(0, value, true);
      out.put(bytes);
    },
  };
}

/** Codec of all remaining bytes, at most `maxLength`. */
export function payload(maxLength: number, errorMessage = 'a payload is too long'): Codec<Uint8Array> {
  const check = (length: number): void => {
    if (length > maxLength) throw new FrameError(errorMessage);
  };
  return {
    read(from) {
      check(from.remaining);
      return from.take(from.remaining).slice();
    },
    write(out, bytes) {
      check(bytes.length);
      out.put(bytes);
    },
  };
}

/** Codec of bytes after one byte with their number. */
export function shortBytes(errorMessage: string): Codec<Uint8Array> {
  return {
    read: (from) => from.take(U8.read(from)).slice(),
    write(out, bytes) {
      if (bytes.length > 0xff) throw new FrameError(errorMessage);
      U8.write(out, bytes.length);
      out.put(bytes);
    },
  };
}

/** Codec of UTF-8 text in the bytes of another codec; other bytes throw an error with `errorMessage`. */
export function utf8(bytes: Codec<Uint8Array>, errorMessage: string): Codec<string> {
  return {
    read(from) {
      const text = bytes.read(from);
      try {
        return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(text);
      } catch {
        throw new FrameError(errorMessage);
      }
    },
    write: (out, text) => bytes.write(out, new TextEncoder().encode(text)),
  };
}

/** Codec that checks values when it reads them; `check` throws an error for wrong ones. */
export function withCheck<Value>(codec: Codec<Value>, check: (value: Value) => void): Codec<Value> {
  return {
    read(from) {
      const value = codec.read(from);
      check(value);
      return value;
    },
    write: codec.write,
  };
}

/** Codec of several values by their index in one byte; other indices throw an error with `errorMessage`. */
export function choiceOf<const Name>(names: readonly Name[], errorMessage: string): Codec<Name> {
  return {
    read(from) {
      const name = names[U8.read(from)];
      if (name === undefined) throw new FrameError(errorMessage);
      return name;
    },
    write: (out, name) => U8.write(out, names.indexOf(name)),
  };
}

type Codecs<Values> = { readonly [Name in keyof Values]: Codec<Values[Name]> };

/** Codec of objects, whose fields have the order of `fields`. */
export function record<Values extends object>(fields: Codecs<Values>): Codec<Readonly<Values>> {
  const entries = Object.entries<Codec<unknown>>(fields);
  return {
    read: (from) => Object.fromEntries(entries.map(([name, codec]) => [name, codec.read(from)])) as Values,
    write(out, value) {
      for (const [name, codec] of entries) codec.write(out, value[name as keyof Values]);
    },
  };
}

/** Codec of a fixed number of values, each with its own codec. */
export function tuple<const Values extends readonly unknown[]>(...codecs: Codecs<Values>): Codec<Values> {
  return {
    read: (from) => codecs.map((codec) => codec.read(from)) as unknown as Values,
    write: (out, values) => codecs.forEach((codec, index) => codec.write(out, values[index])),
  };
}

/** Codec of a list of values after one byte with their number. */
export function shortList<Value>(codec: Codec<Value>): Codec<readonly Value[]> {
  return {
    read: (from) => Array.from({ length: U8.read(from) }, () => codec.read(from)),
    write(out, values) {
      U8.write(out, values.length);
      for (const value of values) codec.write(out, value);
    },
  };
}

/** Codec of a value after a fixed byte, such as a version; other bytes throw an error with `errorMessage`. */
export function withPrefix<Value>(byte: number, errorMessage: string, codec: Codec<Value>): Codec<Value> {
  return {
    read(from) {
      if (U8.read(from) !== byte) throw new FrameError(errorMessage);
      return codec.read(from);
    },
    write(out, value) {
      U8.write(out, byte);
      codec.write(out, value);
    },
  };
}

/** Codes and bodies of messages, by kind. */
type Kinds = Readonly<Record<string, readonly [code: number, body: Codec<any>]>>;

/** Message of one of several kinds: an object with the kind and the fields of the body. */
export type MessageOf<Table extends Kinds> = {
  [Kind in keyof Table]: { readonly kind: Kind } & ValueOf<Table[Kind][1]>;
}[keyof Table];

/**
 * Codec of messages: the code of the kind in one byte, then the body; other codes throw an error with `errorMessage`.
 */
export function kindsOf<const Table extends Kinds>(table: Table, errorMessage: string): Codec<MessageOf<Table>> {
  return {
    read(from) {
      const code = U8.read(from);
      const entry = Object.entries<Kinds[string]>(table).find(([, [each]]) => each === code);
      if (!entry) throw new FrameError(errorMessage);
      const [kind, [, body]] = entry;
      return { kind, ...body.read(from) } as MessageOf<Table>;
    },
    write(out, message) {
      const [code, body] = table[message.kind] as Kinds[string];
      U8.write(out, code);
      body.write(out, message);
    },
  };
}
