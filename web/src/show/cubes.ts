/** A cube map on the GPU: colour, and from ring 1 on the codes of range. Tiles of it can be replaced. */
import { CubeTexture, type WebGLRenderer } from 'three';
import type { MapUpdate } from '../decode/messages';
import type { Step } from './uploads';

export interface Cube {
  readonly color: CubeTexture;
  readonly codes: CubeTexture;
  /** The ring whose map it holds; null for none. */
  holds: number | null;
  /** Whether it has codes. */
  hasRange: boolean;
  dispose(): void;
}

/** Rows of a face that are uploaded in a step: a megabyte of a face of 1024². */
const ROWS = 256;
export const FACES = 6;

export function createCube(renderer: WebGLRenderer, faceSize: number): Cube {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const color = wrapped(renderer, allocated(gl, faceSize, gl.SRGB8_ALPHA8, gl.LINEAR));
  const codes = wrapped(renderer, allocated(gl, faceSize, gl.R16UI, gl.NEAREST));
  renderer.resetState();
  return {
    color,
    codes,
    holds: null,
    hasRange: false,
    dispose() {
      for (const texture of [color, codes]) {
        gl.deleteTexture(handleOf(renderer, texture));
        renderer.properties.remove(texture);
      }
    },
  };
}

function allocated(gl: WebGL2RenderingContext, size: number, format: number, filter: number): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
  gl.texStorage2D(gl.TEXTURE_CUBE_MAP, 1, format, size, size);
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, filter);
  return texture;
}

/** three.js's name for a texture that it did not make. It has version 0, so that three.js uploads nothing. */
function wrapped(renderer: WebGLRenderer, handle: WebGLTexture): CubeTexture {
  const texture = new CubeTexture();
  (renderer.properties.get(texture) as { __webglTexture: WebGLTexture }).__webglTexture = handle;
  return texture;
}

function handleOf(renderer: WebGLRenderer, texture: CubeTexture): WebGLTexture {
  return (renderer.properties.get(texture) as { __webglTexture: WebGLTexture }).__webglTexture;
}

/** The colours of a cube, for WebGL itself. */
export function colorOf(renderer: WebGLRenderer, { color }: Cube): WebGLTexture {
  return handleOf(renderer, color);
}

/** Steps after which the cube holds a ring's map. */
export function* cubeSteps(
  renderer: WebGLRenderer,
  cube: Cube,
  update: MapUpdate,
  ring: number,
  layout: { readonly face_size: number; readonly tile: number },
): Generator<Step> {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const size = layout.face_size;
  const put = (texture: CubeTexture, face: number, box: Box, data: Uint8Array | Uint16Array): void => {
    renderer.state.activeTexture(gl.TEXTURE0);
    renderer.state.bindTexture(gl.TEXTURE_CUBE_MAP, handleOf(renderer, texture));
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const target = gl.TEXTURE_CUBE_MAP_POSITIVE_X + face;
    const [format, type] =
      data instanceof Uint8Array ? [gl.RGBA, gl.UNSIGNED_BYTE] : [gl.RED_INTEGER, gl.UNSIGNED_SHORT];
    gl.texSubImage2D(target, 0, box.x, box.y, box.width, box.height, format, type, data);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
  };
  cube.holds = null;
  if (update.whole) {
    for (let face = 0; face < FACES; face++) {
      for (let y = 0; y < size; y += ROWS) {
        const box = { x: 0, y, width: size, height: Math.min(ROWS, size - y) };
        const rows = <T extends Uint8Array | Uint16Array>(data: T | undefined, texel: number): T => {
          if (!data) throw new Error('a map has fewer than six faces');
          return data.subarray(y * size * texel, (y + box.height) * size * texel) as T;
        };
        yield () => put(cube.color, face, box, rows(update.color[face], 4));
        const { codes } = update;
        if (codes) yield () => put(cube.codes, face, box, rows(codes[face], 1));
      }
    }
    cube.hasRange = update.codes !== null;
  } else {
    const { tile } = layout;
    const across = size / tile;
    const area = tile * tile;
    for (let i = 0; i < update.tiles.length; i++) {
      const number = update.tiles[i] ?? 0;
      const face = Math.floor(number / (across * across));
      const place = number % (across * across);
      const box = { x: (place % across) * tile, y: Math.floor(place / across) * tile, width: tile, height: tile };
      yield () => {
        put(cube.color, face, box, update.color.subarray(4 * i * area, 4 * (i + 1) * area));
        put(cube.codes, face, box, update.codes.subarray(i * area, (i + 1) * area));
      };
    }
  }
  cube.holds = ring;
}

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}
