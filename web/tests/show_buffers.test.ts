import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createBuffers, type Numbers } from '../src/show/buffers';
import { STEP_BYTES } from '../src/show/uploads';

/** Creates a WebGL that has its buffers in memory. */
function createFakeGl() {
  const kinds: string[] = [];
  let [bound, array, deleted]: [Uint8Array[] | null, string | null, number] = [null, 'three', 0];
  const gl = {
    ELEMENT_ARRAY_BUFFER: 'index',
    VERTEX_ARRAY_BINDING: 'vertex array',
    createBuffer: () => [],
    deleteBuffer: () => (deleted += 1),
    getParameter: () => array,
    bindVertexArray: (to: string | null) => (array = to),
    bindBuffer(target: unknown, buffer: Uint8Array[]) {
      if (target === 'index') kinds.push(`index while ${array} is bound`);
      else bound = buffer;
    },
    bufferData: (_: unknown, size: number) => bound?.push(new Uint8Array(size)),
    bufferSubData(_: unknown, start: number, data: Numbers) {
      bound?.[0]?.set(new Uint8Array(data.buffer, data.byteOffset, data.byteLength), start);
    },
  };
  const state = (): unknown[] => [kinds, array, deleted];
  return { gl: gl as unknown as WebGL2RenderingContext, state };
}

test('large arrays are uploaded in several steps, and small ones share a step', () => {
  const { gl, state } = createFakeGl();
  const position = Float32Array.from({ length: 300_000 }, (_, n) => n);
  const index = Uint16Array.from({ length: 1000 }, (_, n) => n);
  const color = Uint16Array.from({ length: 400 }, (_, n) => n);
  const buffers = createBuffers<'position' | 'normal' | 'color' | 'index'>(gl, {
    position: { rows: position, width: 3 },
    normal: null,
    color: { rows: color, width: 4, isNormalized: true },
    index: { rows: index, width: 1 },
  });
  const sizes: number[] = [];
  for (const { bytes, run } of buffers.steps()) {
    sizes.push(bytes);
    run();
  }
  assert.ok(sizes.every((bytes) => bytes <= STEP_BYTES));
  assert.equal(sizes.length, Math.ceil(position.byteLength / STEP_BYTES));
  assert.equal(sizes.reduce((sum, bytes) => sum + bytes, 0), position.byteLength + index.byteLength + color.byteLength);
  const { attributes } = buffers;
  assert.deepEqual(Object.keys(attributes), ['position', 'color', 'index']);
  assert.deepEqual([attributes.position?.count, attributes.color?.normalized], [100_000, true]);
  for (const [name, rows] of Object.entries({ position, color, index })) {
    const [content] = attributes[name as 'position']?.buffer as unknown as [Uint8Array];
    assert.deepEqual(content, new Uint8Array(rows.buffer), name);
  }
  // The index buffer is bound as such, without a change to the vertex array of three.js.
  assert.deepEqual(state(), [['index while null is bound'], 'three', 0]);
  buffers.dispose();
  assert.equal(state()[2], 3);
});
