/** Range of the map in a direction, read back from the GPU. */
import type { WebGLRenderer } from 'three';
import type { Vector } from '../control/vector';
import type { Shared } from '../show/materials';

/** Code of pixels without a range. */
const NOTHING = 65535;

export interface Texel {
  readonly face: number;
  readonly x: number;
  readonly y: number;
}

/** Returns the texel of a cube map that GL samples for a direction. */
export function texelOf([x, y, z]: Vector, size: number): Texel {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const longest = Math.max(ax, ay, az);
  const [face, across, down] =
    ax === longest ? (x > 0 ? [0, -z, -y] : [1, z, -y])
    : ay === longest ? (y > 0 ? [2, x, z] : [3, x, -z])
    : z > 0 ? [4, x, -y] : [5, -x, -y];
  const place = (value: number): number => Math.min(Math.floor((value / longest + 1) * 0.5 * size), size - 1);
  return { face, x: place(across), y: place(down) };
}

/** Returns the range in metres from the centre in the last picture's map; null if there is none. */
export function rangeIn(renderer: WebGLRenderer, { codes, coding }: Shared, direction: Vector): number | null {
  const { x: least, y: step, z: size, w: hasRange } = coding.value;
  const { __webglTexture: texture } = renderer.properties.get(codes.value) as { __webglTexture?: WebGLTexture };
  if (hasRange === 0 || !texture) return null;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { face, x, y } = texelOf(direction, size);
  const frame = gl.createFramebuffer();
  const code = new Uint32Array(4);
  renderer.state.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, texture, 0);
  gl.readPixels(x, y, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, code);
  renderer.state.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(frame);
  const [found = NOTHING] = code;
  return found === NOTHING ? null : least * Math.exp(found * step);
}
