/** Draws the geometry of near leaves into the sample buffer, with the depth and lighting of splats. */
import type { Sampler } from '../../../decode/messages';
import { ROWS } from '../../../decode/placements';
import type { Piece } from '../../decode/leaf';
import type { Triple } from '../../store/layout';
import type { Projector } from '../projection';
import { programOf } from './gl';
import { MESH_FRAGMENT, MESH_VERTEX } from './shaders';

/** A piece of geometry on the GPU. */
export interface Mesh {
  readonly origin: Triple;
  readonly material: Piece['material'];
  readonly array: WebGLVertexArrayObject;
  readonly buffers: readonly WebGLBuffer[];
  /** Textures of colour and of emission; null for none. */
  readonly textures: readonly (WebGLTexture | null)[];
  readonly kind: number;
  readonly corners: number;
  readonly copies: number;
  readonly bytes: number;
}

export function createMeshes(gl: WebGL2RenderingContext) {
  const { at, program } = programOf(gl, MESH_VERTEX, MESH_FRAGMENT);
  const white = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, white);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([255, 255, 255, 255]));
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);

  function upload(piece: Piece): Mesh {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const buffers: WebGLBuffer[] = [];
    const fillBuffer = (target: number, data: ArrayBufferView<ArrayBuffer>): void => {
      const buffer = gl.createBuffer();
      buffers.push(buffer);
      gl.bindBuffer(target, buffer);
      gl.bufferData(target, data, gl.STATIC_DRAW);
    };
    const addAttribute = (place: number, data: Float32Array | Uint16Array | null, width: number): number => {
      if (!data) return 0;
      fillBuffer(gl.ARRAY_BUFFER, data as ArrayBufferView<ArrayBuffer>);
      const isFloat = data instanceof Float32Array;
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, width, isFloat ? gl.FLOAT : gl.UNSIGNED_SHORT, !isFloat, 0, 0);
      return data.byteLength;
    };
    let bytes = addAttribute(0, piece.positions, 3) + addAttribute(1, piece.normals, 3);
    bytes += addAttribute(2, piece.uvs, 2) + addAttribute(3, piece.colors, 4);
    fillBuffer(gl.ARRAY_BUFFER, piece.placements as ArrayBufferView<ArrayBuffer>);
    for (let row = 0; row < 3; row++) {
      gl.enableVertexAttribArray(4 + row);
      gl.vertexAttribPointer(4 + row, 4, gl.FLOAT, false, 4 * ROWS, 16 * row);
      gl.vertexAttribDivisor(4 + row, 1);
    }
    fillBuffer(gl.ELEMENT_ARRAY_BUFFER, piece.indices as ArrayBufferView<ArrayBuffer>);
    gl.bindVertexArray(null);
    const images = [piece.image, piece.glow];
    // Mipmaps add a third.
    for (const image of images) bytes += image ? Math.ceil((16 * image.width * image.height) / 3) : 0;
    return {
      origin: piece.origin,
      material: piece.material,
      array,
      buffers,
      textures: [
        piece.image && createTexture(piece.image, piece.material.imageSampler),
        piece.glow && createTexture(piece.glow, piece.material.glowSampler),
      ],
      kind: piece.indices instanceof Uint16Array ? gl.UNSIGNED_SHORT : gl.UNSIGNED_INT,
      corners: piece.indices.length,
      copies: piece.placements.length / ROWS,
      bytes: bytes + piece.placements.byteLength + piece.indices.byteLength,
    };
  }

  function drop({ array, buffers, textures }: Mesh): void {
    gl.deleteVertexArray(array);
    for (const buffer of buffers) gl.deleteBuffer(buffer);
    for (const texture of textures) gl.deleteTexture(texture);
  }

  /** Draws meshes into the bound samples with `nearest` as the near distance; returns the number of triangles. */
  function draw(meshes: readonly Mesh[], { eye, rows, width, height }: Projector, nearest: number): number {
    gl.useProgram(program);
    gl.uniform3fv(at('gradients'), rows.flat());
    gl.uniform2f(at('screen'), width, height);
    gl.uniform1f(at('nearest'), nearest);
    gl.uniform1i(at('image'), 0);
    gl.uniform1i(at('glow'), 1);
    let triangles = 0;
    for (const mesh of meshes) {
      const { origin, material, textures, corners, copies } = mesh;
      // Computed in float64, because float32 is precise only near the eye.
      gl.uniform3f(at('offset'), origin[0] - eye[0], origin[1] - eye[1], origin[2] - eye[2]);
      gl.uniform4fv(at('base'), material.color);
      gl.uniform3fv(at('emission'), material.emission ?? [0, 0, 0]);
      gl.uniform1f(at('cutoff'), material.cutoff ?? -1);
      gl.uniform1f(at('unlit'), material.isUnlit ? 1 : 0);
      textures.forEach((texture, unit) => {
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture ?? white);
      });
      gl.bindVertexArray(mesh.array);
      // Values for missing arrays: zero normals, which select flat shading, and white.
      gl.vertexAttrib3f(1, 0, 0, 0);
      gl.vertexAttrib4f(3, 1, 1, 1, 1);
      gl.drawElementsInstanced(gl.TRIANGLES, corners, mesh.kind, 0, copies);
      triangles += (corners / 3) * copies;
    }
    gl.bindVertexArray(null);
    return triangles;
  }

  function createTexture(image: ImageBitmap, [wrapU, wrapV, filter]: Sampler): WebGLTexture {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
    gl.generateMipmap(gl.TEXTURE_2D);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrapU);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrapV);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
    image.close();
    return texture;
  }

  return { upload, drop, draw };
}
