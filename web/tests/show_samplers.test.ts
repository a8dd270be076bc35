import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CubeTexture, type ExternalTexture, Group, type Texture, type WebGLRenderer } from 'three';
import type { Band, Material, Piece, Sampler } from '../src/decode/messages';
import { createStore } from '../src/show/buffers';
import { createMaterials, createShared } from '../src/show/materials';
import type { PieceMesh } from '../src/show/pieces';
import { partSteps, type Region } from '../src/show/region';
import { copyTexture, createPictures } from '../src/show/textures';

/** Creates a renderer whose WebGL records the parameters of textures, the copies between them and the deleted ones. */
function createFakeRenderer() {
  const parameters = new Map<unknown, Record<string, unknown>>();
  const [copied, deleted]: [unknown[][], unknown[]] = [[], []];
  let [bound, source]: unknown[] = [null, null];
  const known: Record<string, unknown> = {
    createTexture: () => ({}),
    deleteTexture: (texture: unknown) => deleted.push(texture),
    texParameteri: (_: unknown, name: string, value: unknown) =>
      parameters.set(bound, { ...parameters.get(bound), [name]: value }),
    framebufferTexture2D: (...taken: unknown[]) => (source = taken[3]),
    copyTexSubImage2D: (...taken: unknown[]) => copied.push([source, bound, ...taken.slice(-2)]),
  };
  // Constants are their names, and other functions do nothing.
  const other = (name: string): unknown => (name === name.toUpperCase() ? name : () => ({}));
  const gl = new Proxy(known, { get: (_, name: string) => known[name] ?? other(name) });
  const state = {
    activeTexture: () => undefined,
    pixelStorei: () => undefined,
    bindTexture: (_: unknown, texture: unknown) => (bound = texture),
  };
  return { renderer: { getContext: () => gl, state } as unknown as WebGLRenderer, parameters, copied, deleted };
}

const [FILE, OTHER] = ['files/aaaaaaaaaaaaaaaa.webp', 'files/bbbbbbbbbbbbbbbb.webp'];
const [REPEATED, CLAMPED]: [Sampler, Sampler] = [[10497, 10497, 9729], [33071, 33648, 9728]];

function pieceOf(change: Partial<Material>): Piece {
  const material: Material = {
    color: [1, 1, 1, 1],
    image: FILE,
    imageSampler: REPEATED,
    cutoff: null,
    emission: [1, 1, 1],
    glow: FILE,
    glowSampler: CLAMPED,
    isUnlit: false,
    ...change,
  };
  const [positions, uvs, indices] = [new Float32Array(9), new Float32Array(6), new Uint16Array(3)];
  return { positions, uvs, indices, normals: null, colors: null, placements: null, sharedKey: null, material, name: '' };
}

/** Loads pieces with pictures of 4 × 2 texels; returns their meshes, and a function that draws one. */
function load(...pieces: Piece[]) {
  const fake = createFakeRenderer();
  const { renderer, parameters } = fake;
  const store = createStore();
  const pictures = createPictures(renderer, (name, texture) => store.textures.set(name, texture));
  const group = new Group();
  const materials = createMaterials(createShared(new CubeTexture(), new CubeTexture()));
  const region = { entry: { cut: 5 }, groups: [new Group(), group], materials } as unknown as Region;
  const copy = (texture: Texture): Texture => copyTexture(renderer, texture);
  const resources = { gl: renderer.getContext() as WebGL2RenderingContext, store, copy, warmUp: () => undefined };
  const bitmap = { width: 4, height: 2, close: () => undefined } as unknown as ImageBitmap;
  const bands: Band[] = [FILE, OTHER].map((name) => ({ name, width: 4, height: 2, y: 0, bitmap }));
  for (const { run } of partSteps(region, 1, { bands, pieces }, resources, pictures)) run();
  const meshes = group.children as PieceMesh[];
  const handleOf = (mesh: PieceMesh, use: string): unknown =>
    (mesh.material.uniforms[use]?.value as ExternalTexture).sourceTexture;
  const samplerOf = (handle: unknown): unknown[] => {
    const { TEXTURE_WRAP_S: u = 10497, TEXTURE_WRAP_T: v = 10497, TEXTURE_MAG_FILTER: filter = 9729 } =
      parameters.get(handle) ?? {};
    return [u, v, filter];
  };
  const draw = (mesh: PieceMesh): unknown[][] => {
    (mesh.material.onBeforeRender as (renderer: WebGLRenderer) => void)(renderer);
    return ['image', 'glow'].map((use) => samplerOf(handleOf(mesh, use)));
  };
  return { ...fake, store, meshes, draw, handleOf };
}

test('a mesh shows one image with a sampler for its colour and another one for its emission', () => {
  const swapped = { imageSampler: CLAMPED, glowSampler: REPEATED };
  const { meshes, draw, copied, deleted, parameters, store, handleOf } = load(pieceOf({}), pieceOf(swapped));
  const [first, second] = meshes as [PieceMesh, PieceMesh];
  for (const _ of [0, 1]) {
    assert.deepEqual(draw(first), [REPEATED, CLAMPED]);
    assert.deepEqual(draw(second), [CLAMPED, REPEATED]);
  }
  // Both meshes use the same copy, which is freed with its file.
  const [image, glow] = [handleOf(first, 'image'), handleOf(first, 'glow')];
  assert.deepEqual([copied.length, copied[0]?.[0] === image, copied[0]?.[1] === glow], [1, true, true]);
  assert.deepEqual(copied[0]?.slice(2), [4, 2]);
  assert.equal(parameters.get(glow)?.['TEXTURE_MIN_FILTER'], 'LINEAR_MIPMAP_LINEAR');
  store.freeExcept(new Set([OTHER]));
  assert.deepEqual([deleted.length, deleted[0] === image, deleted[1] === glow], [2, true, true]);
});

test('images are not copied for equal samplers, or for different files', () => {
  const { meshes, draw, copied } = load(pieceOf({ imageSampler: CLAMPED }), pieceOf({ glow: OTHER }));
  const [equal, different] = meshes as [PieceMesh, PieceMesh];
  assert.deepEqual(draw(equal), [CLAMPED, CLAMPED]);
  assert.deepEqual(draw(different), [REPEATED, CLAMPED]);
  assert.equal(copied.length, 0);
});
