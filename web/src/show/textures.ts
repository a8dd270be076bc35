/** Textures that are uploaded in steps: cube maps with their range codes, and images in bands of rows. */
import { CubeTexture, ExternalTexture, type Texture, type WebGLRenderer } from 'three';
import type { MapLayout, RangeScale } from '../bundle/manifest';
import { type Band, type MapUpdate, type Sampler, tileAt } from '../decode/messages';
import { type Step, STEP_BYTES } from './uploads';

export type Cube = ReturnType<typeof createCube>;

export const FACES = 6;
/** Scale of a map without range codes. */
const NO_SCALE: RangeScale = { least: 1, step: 1 };

export function createCube(renderer: WebGLRenderer, size: number, scale: RangeScale = NO_SCALE) {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const color = wrapTexture(renderer, allocateCube(gl, size, gl.SRGB8_ALPHA8, gl.LINEAR));
  const codes = wrapTexture(renderer, allocateCube(gl, size, gl.R16UI, gl.NEAREST));
  renderer.resetState();
  return {
    color,
    codes,
    /** Ring whose map is complete in the cube; null for none. */
    ringShown: null as number | null,
    hasRange: false,
    /** Texels per side of a face. */
    size,
    scale,
    dispose(): void {
      for (const texture of [color, codes]) {
        gl.deleteTexture(handleOf(renderer, texture));
        renderer.properties.remove(texture);
      }
    },
  };
}

function allocateCube(gl: WebGL2RenderingContext, size: number, format: number, filter: number): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
  gl.texStorage2D(gl.TEXTURE_CUBE_MAP, 1, format, size, size);
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, filter);
  return texture;
}

/** Wraps a texture for three.js, with version 0, so that three.js uploads nothing to it. */
function wrapTexture(renderer: WebGLRenderer, handle: WebGLTexture): CubeTexture {
  const texture = new CubeTexture();
  (renderer.properties.get(texture) as { __webglTexture: WebGLTexture }).__webglTexture = handle;
  return texture;
}

function handleOf(renderer: WebGLRenderer, texture: CubeTexture): WebGLTexture {
  return (renderer.properties.get(texture) as { __webglTexture: WebGLTexture }).__webglTexture;
}

/** Returns the WebGL texture of a cube's colours. */
export function colorOf(renderer: WebGLRenderer, { color }: Cube): WebGLTexture {
  return handleOf(renderer, color);
}

/** Steps that upload the map of a ring into a cube. */
export function* cubeSteps(renderer: WebGLRenderer, cube: Cube, update: MapUpdate, ring: number, layout: MapLayout) {
  const { face_size: size, tile } = layout;
  cube.ringShown = null;
  if (update.whole) {
    for (const [face, color] of update.color.entries()) {
      const box = { face, x: 0, y: 0, width: size, height: size };
      const codes = update.codes?.[face];
      yield* boxSteps(renderer, cube.color, box, color);
      if (codes) yield* boxSteps(renderer, cube.codes, box, codes);
    }
    cube.hasRange = update.codes !== null;
  } else {
    const area = tile * tile;
    for (const [index, number] of update.tiles.entries()) {
      const box = { ...tileAt(number, size / tile, tile), width: tile, height: tile };
      yield* boxSteps(renderer, cube.color, box, update.color.subarray(4 * index * area, 4 * (index + 1) * area));
      yield* boxSteps(renderer, cube.codes, box, update.codes.subarray(index * area, (index + 1) * area));
    }
  }
  cube.ringShown = ring;
}

/** Rectangle of texels in a face. */
type Box = ReturnType<typeof tileAt> & { readonly width: number; readonly height: number };
type Texels = Uint8Array | Uint16Array;

/** Steps that upload a rectangle of texels, as many rows at a time as fit into a step. */
function* boxSteps(renderer: WebGLRenderer, texture: CubeTexture, box: Box, data: Texels): Generator<Step> {
  const row = data.length / box.height;
  const rows = Math.max(Math.floor(STEP_BYTES / (row * data.BYTES_PER_ELEMENT)), 1);
  for (let first = 0; first < box.height; first += rows) {
    const part = { ...box, y: box.y + first, height: Math.min(rows, box.height - first) };
    const texels = data.subarray(first * row, (first + part.height) * row);
    yield { kind: 'map', bytes: texels.byteLength, run: () => uploadTexels(renderer, texture, part, texels) };
  }
}

/** Binds a texture so that rows are uploaded unflipped, and without premultiplied alpha. */
function bindForUpload(renderer: WebGLRenderer, target: 'TEXTURE_2D' | 'TEXTURE_CUBE_MAP', texture: WebGLTexture) {
  const [gl, { state }] = [renderer.getContext() as WebGL2RenderingContext, renderer];
  state.activeTexture(gl.TEXTURE0);
  state.bindTexture(gl[target], texture);
  state.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  state.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
}

function uploadTexels(renderer: WebGLRenderer, texture: CubeTexture, box: Box, data: Texels): void {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const [{ state }, { face, x, y, width, height }] = [renderer, box];
  bindForUpload(renderer, 'TEXTURE_CUBE_MAP', handleOf(renderer, texture));
  state.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  const target = gl.TEXTURE_CUBE_MAP_POSITIVE_X + face;
  const [format, type] = data instanceof Uint8Array ? [gl.RGBA, gl.UNSIGNED_BYTE] : [gl.RED_INTEGER, gl.UNSIGNED_SHORT];
  gl.texSubImage2D(target, 0, x, y, width, height, format, type, data);
  state.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
}

/** Samplers that were set last. WebGL's default repeats and filters. */
const samplers = new WeakMap<WebGLTexture, string>();

/** Sets a texture's sampler before a mesh is drawn with it: meshes may show one texture with different samplers. */
export function setSampler(renderer: WebGLRenderer, texture: Texture, [wrapU, wrapV, filter]: Sampler): void {
  const handle = (texture as ExternalTexture).sourceTexture as WebGLTexture | null;
  const codes = [wrapU, wrapV, filter].join();
  if (!handle || (samplers.get(handle) ?? DEFAULT_SAMPLER) === codes) return;
  samplers.set(handle, codes);
  const [gl, { state }] = [renderer.getContext() as WebGL2RenderingContext, renderer];
  state.bindTexture(gl.TEXTURE_2D, handle);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrapU);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrapV);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
}

const DEFAULT_SAMPLER = '10497,10497,9729';

/** Size of a picture in texels. */
type Size = Pick<Band, 'width' | 'height'>;

/** Allocates a texture with mipmaps, and leaves it bound. */
function allocatePicture(renderer: WebGLRenderer, { width, height }: Size): WebGLTexture {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const texture = gl.createTexture();
  bindForUpload(renderer, 'TEXTURE_2D', texture);
  const levels = 1 + Math.floor(Math.log2(Math.max(width, height)));
  gl.texStorage2D(gl.TEXTURE_2D, levels, gl.SRGB8_ALPHA8, width, height);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  return texture;
}

/** Creates the mipmaps of the bound texture, and wraps it for three.js. */
function finishPicture(renderer: WebGLRenderer, handle: WebGLTexture, { width, height }: Size): ExternalTexture {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  gl.generateMipmap(gl.TEXTURE_2D);
  const texture = new ExternalTexture(handle);
  texture.userData = { width, height } satisfies Size;
  texture.addEventListener('dispose', () => gl.deleteTexture(handle));
  return texture;
}

/** Copies a picture's texture on the GPU, so that the copy can have another sampler. */
export function copyTexture(renderer: WebGLRenderer, texture: Texture): Texture {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const [size, source] = [texture.userData as Size, (texture as ExternalTexture).sourceTexture as WebGLTexture | null];
  const handle = allocatePicture(renderer, size);
  // three.js does not notice that another framebuffer was bound meanwhile.
  const before = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, source, 0);
  gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, size.width, size.height);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, before);
  gl.deleteFramebuffer(framebuffer);
  return finishPicture(renderer, handle, size);
}

export type Pictures = ReturnType<typeof createPictures>;

/** Assembles textures from bands; calls `onComplete` with each complete texture. */
export function createPictures(renderer: WebGLRenderer, onComplete: (name: string, texture: Texture) => void) {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const incomplete = new Map<string, WebGLTexture>();

  const bind = (texture: WebGLTexture): void => bindForUpload(renderer, 'TEXTURE_2D', texture);

  function begin(band: Band): WebGLTexture {
    const texture = allocatePicture(renderer, band);
    incomplete.set(band.name, texture);
    return texture;
  }

  function uploadBand(band: Band): void {
    bind(incomplete.get(band.name) ?? begin(band));
    renderer.state.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, band.y, gl.RGBA, gl.UNSIGNED_BYTE, band.bitmap);
    band.bitmap.close();
  }

  function finish(band: Band): void {
    const handle = incomplete.get(band.name);
    if (!handle) return;
    incomplete.delete(band.name);
    bind(handle);
    onComplete(band.name, finishPicture(renderer, handle, band));
  }

  return {
    /** Steps that upload a band, and finish the texture after its last band. */
    *steps(band: Band): Generator<Step> {
      const { y, bitmap, height } = band;
      const isLast = y + bitmap.height === height;
      yield { kind: 'picture', bytes: 4 * bitmap.width * bitmap.height, run: () => uploadBand(band) };
      if (isLast) yield { kind: 'picture', bytes: 0, run: () => finish(band) };
    },
    /** Frees incomplete textures. */
    dispose(): void {
      for (const texture of incomplete.values()) gl.deleteTexture(texture);
      incomplete.clear();
    },
  };
}
