/** Textures on the GPU whose images arrive in bands of rows. */
import { ExternalTexture, type Texture, type WebGLRenderer } from 'three';
import type { Band } from '../decode/messages';
import type { Step } from './uploads';

export interface Pictures {
  /** Steps that upload a band, and finish the texture after its last band. */
  steps(band: Band): Generator<Step>;
  /** Frees incomplete textures. */
  dispose(): void;
}

/** Collects bands while a file is loaded; `whole` is called with complete textures. */
export function createPictures(renderer: WebGLRenderer, whole: (name: string, texture: Texture) => void): Pictures {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const coming = new Map<string, WebGLTexture>();

  function bind(texture: WebGLTexture): void {
    renderer.state.activeTexture(gl.TEXTURE0);
    renderer.state.bindTexture(gl.TEXTURE_2D, texture);
  }

  function begin({ name, width, height }: Band): WebGLTexture {
    const texture = gl.createTexture();
    coming.set(name, texture);
    bind(texture);
    const levels = 1 + Math.floor(Math.log2(Math.max(width, height)));
    gl.texStorage2D(gl.TEXTURE_2D, levels, gl.SRGB8_ALPHA8, width, height);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.REPEAT);
    return texture;
  }

  function send(band: Band): void {
    bind(coming.get(band.name) ?? begin(band));
    const { state } = renderer;
    state.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    state.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    state.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, band.y, gl.RGBA, gl.UNSIGNED_BYTE, band.rows);
    band.rows.close();
  }

  function finish(name: string): void {
    const handle = coming.get(name);
    if (!handle) return;
    coming.delete(name);
    bind(handle);
    gl.generateMipmap(gl.TEXTURE_2D);
    const texture = new ExternalTexture(handle);
    texture.addEventListener('dispose', () => gl.deleteTexture(handle));
    whole(name, texture);
  }

  return {
    *steps(band) {
      const { name, y, rows, height } = band;
      const isLast = y + rows.height === height;
      yield { kind: 'picture', bytes: 4 * rows.width * rows.height, run: () => send(band) };
      if (isLast) yield { kind: 'picture', bytes: 0, run: () => finish(name) };
    },
    dispose() {
      for (const texture of coming.values()) gl.deleteTexture(texture);
      coming.clear();
    },
  };
}
