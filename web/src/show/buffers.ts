/** GPU buffers of arrays that are uploaded in steps, and the resources that regions share. */
import { GLBufferAttribute, type Texture } from 'three';
import { type Step, STEP_BYTES } from './uploads';

export type Numbers = Float32Array | Uint16Array | Uint32Array;

/** Arrays by name; each is complete on the GPU after all steps. */
export interface Buffers<Name extends string> {
  readonly attributes: Readonly<Partial<Record<Name, GLBufferAttribute>>>;
  /** Steps that upload the arrays. */
  steps(): Generator<Step>;
  dispose(): void;
}

/** Array of rows of `width` numbers. */
export interface Column {
  readonly rows: Numbers;
  readonly width: number;
  /** Whether integers are normalized by their greatest value. */
  readonly isNormalized?: boolean;
}

/** Allocates GPU memory for arrays without uploading them. */
export function createBuffers<Name extends string>(
  gl: WebGL2RenderingContext,
  columns: Readonly<Partial<Record<Name, Column | null>>>,
): Buffers<Name> {
  type Attributes = Buffers<Name>['attributes'];
  const arrays = Object.entries<Column | null | undefined>(columns).flatMap(([name, column]) =>
    column ? [{ name, rows: column.rows, attribute: attributeOf(gl, column, name === 'index') }] : [],
  );
  return {
    attributes: Object.fromEntries(arrays.map(({ name, attribute }) => [name, attribute])) as Attributes,
    *steps() {
      for (const parts of groupParts(arrays.flatMap(({ rows, attribute }) => [...partsOf(rows, attribute.buffer)]))) {
        const bytes = parts.reduce((sum, { data }) => sum + data.byteLength, 0);
        yield {
          kind: 'arrays',
          bytes,
          run: () => {
            for (const { buffer, data, start } of parts) {
              gl.bindBuffer(TARGET, buffer);
              gl.bufferSubData(TARGET, start, data);
            }
          },
        };
      }
    },
    dispose() {
      for (const { attribute } of arrays) gl.deleteBuffer(attribute.buffer);
    },
  };
}

/** WebGL's COPY_WRITE_BUFFER, which accepts all arrays and is not used by three.js. */
const TARGET = 0x8f37;

function attributeOf(gl: WebGL2RenderingContext, { rows, width, isNormalized = false }: Column, isIndex: boolean) {
  const buffer = gl.createBuffer();
  if (isIndex) markIndex(gl, buffer);
  gl.bindBuffer(TARGET, buffer);
  gl.bufferData(TARGET, rows.byteLength, gl.STATIC_DRAW);
  const isShort = rows instanceof Uint16Array;
  const type = rows instanceof Float32Array ? gl.FLOAT : isShort ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT;
  // The declaration of three.js lacks 32-bit integers.
  const declared = type as typeof gl.FLOAT | typeof gl.UNSIGNED_SHORT;
  return new GLBufferAttribute(buffer, declared, width, isShort ? 2 : 4, rows.length / width, isNormalized);
}

/** Marks a buffer as an index buffer for WebGL, without changing the vertex array that three.js has bound. */
function markIndex(gl: WebGL2RenderingContext, buffer: WebGLBuffer): void {
  const before = gl.getParameter(gl.VERTEX_ARRAY_BINDING) as WebGLVertexArrayObject | null;
  gl.bindVertexArray(null);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
  gl.bindVertexArray(before);
}

/** Part of an array, and its byte offset in the buffer. */
interface BufferPart {
  readonly buffer: WebGLBuffer;
  readonly data: Numbers;
  readonly start: number;
}

function* partsOf(rows: Numbers, buffer: WebGLBuffer): Generator<BufferPart> {
  const count = STEP_BYTES / rows.BYTES_PER_ELEMENT;
  for (let first = 0; first < rows.length; first += count)
    yield { buffer, data: rows.subarray(first, first + count), start: first * rows.BYTES_PER_ELEMENT };
}

/** Combines parts up to the size of a step. */
function* groupParts(parts: Iterable<BufferPart>): Generator<BufferPart[]> {
  let group: BufferPart[] = [];
  let bytes = 0;
  for (const part of parts) {
    if (group.length > 0 && bytes + part.data.byteLength > STEP_BYTES) {
      yield group;
      [group, bytes] = [[], 0];
    }
    group.push(part);
    bytes += part.data.byteLength;
  }
  if (group.length > 0) yield group;
}

/** Arrays of a mesh without its placements. */
export type MeshArrays = Buffers<'position' | 'normal' | 'uv' | 'color' | 'index'>;

/** Resources that regions share. */
export type Store = ReturnType<typeof createStore>;

export function createStore() {
  /** Textures by file name. */
  const textures = new Map<string, Texture>();
  /** Second textures of files that a material shows with two samplers: a WebGL texture has one at a time. */
  const copies = new Map<string, Texture>();
  /** Names of the files in the geometry worker: shared buffers, and the file of dynamic objects. */
  const buffers = new Set<string>();
  const sharedArrays = new Map<string, { arrays: MeshArrays; users: number }>();

  return {
    textures,
    buffers,
    /** Returns a copy of a file's texture, which `copy` makes at first; null if the file is not loaded. */
    copyOf(name: string, copy: (texture: Texture) => Texture): Texture | null {
      const [texture, known] = [textures.get(name), copies.get(name)];
      if (known || !texture) return known ?? null;
      const made = copy(texture);
      copies.set(name, made);
      return made;
    },
    /** Returns the arrays of a mesh, which meshes of the same name share, and counts a user of them. */
    acquire(name: string | null, make: () => MeshArrays): MeshArrays {
      if (name === null) return make();
      const entry = sharedArrays.get(name) ?? { arrays: make(), users: 0 };
      sharedArrays.set(name, entry);
      entry.users += 1;
      return entry.arrays;
    },
    /** Counts one user less of a mesh's arrays; returns true if none is left, so that they can be freed. */
    release(name: string | null): boolean {
      const entry = name === null ? undefined : sharedArrays.get(name);
      if (!entry || name === null) return true;
      entry.users -= 1;
      if (entry.users > 0) return false;
      sharedArrays.delete(name);
      return true;
    },
    /** Frees all textures but those of these files; returns the names of the buffers that the worker must free. */
    freeExcept(files: ReadonlySet<string>): string[] {
      for (const [name, texture] of textures) {
        if (files.has(name)) continue;
        for (const each of [texture, copies.get(name)]) each?.dispose();
        textures.delete(name);
        copies.delete(name);
      }
      const unneeded = [...buffers].filter((name) => !files.has(name));
      for (const name of unneeded) buffers.delete(name);
      return unneeded;
    },
    /** Number of arrays that several meshes share. */
    get shared(): number {
      return [...sharedArrays.values()].filter(({ users }) => users > 1).length;
    },
  };
}
