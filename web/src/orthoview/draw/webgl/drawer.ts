/** Draws views by WebGL 2: splats as points into a sample buffer, which is then resolved to the canvas. */
import type { Camera } from '../../cut/camera';
import { type Part, type Splats, WORDS } from '../../decode/pack';
import type { Layout } from '../../store/layout';
import { type Drawer, type FrameCounts, gridOf, type Item, nearDistanceOf } from '../drawer';
import {
  boundsOf,
  mayLieIn,
  type Model,
  type Projector,
  projectorOf,
  rowsOf,
  sightOf,
  VECTORS,
  writeView,
} from '../sight';
import { type Program, programOf, type Target, targetOf } from './gl';
import { type Mesh, Meshes } from './meshes';
import { RESOLVE_FRAGMENT, SPLAT_FRAGMENT, SPLAT_VERTEX, FULL_SCREEN_VERTEX } from './shaders';

/** A layer of a view on the GPU. */
export interface Layer {
  readonly model: Model;
  readonly parts: readonly Part[];
  readonly array: WebGLVertexArrayObject;
  readonly buffer: WebGLBuffer;
  readonly bytes: number;
}

export class WebglDrawer implements Drawer<Layer, Mesh> {
  readonly #gl: WebGL2RenderingContext;
  readonly #splats: Program;
  readonly #resolve: Program;
  readonly meshes: Meshes;
  readonly #numbers = new Float32Array(4 * VECTORS);
  readonly #maxPointSize: number;
  readonly #maxTextureSize: number;
  #target: Target | null = null;
  #fence: WebGLSync | null = null;
  readonly unhidden = null;

  constructor(readonly canvas: HTMLCanvasElement | OffscreenCanvas, readonly layout: Layout) {
    const gl = canvas.getContext('webgl2', { alpha: false, antialias: false, depth: false });
    if (!gl) throw new Error('this browser has no WebGL 2');
    this.#gl = gl as WebGL2RenderingContext;
    this.#splats = programOf(this.#gl, SPLAT_VERTEX, SPLAT_FRAGMENT);
    this.#resolve = programOf(this.#gl, FULL_SCREEN_VERTEX, RESOLVE_FRAGMENT);
    this.meshes = new Meshes(this.#gl);
    this.#maxPointSize = (this.#gl.getParameter(this.#gl.ALIASED_POINT_SIZE_RANGE) as Float32Array)[1] ?? 1;
    this.#maxTextureSize = this.#gl.getParameter(this.#gl.MAX_TEXTURE_SIZE) as number;
  }

  upload(model: Model, { words, parts }: Splats): Layer {
    const gl = this.#gl;
    const [array, buffer] = [gl.createVertexArray(), gl.createBuffer()];
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, words, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribIPointer(0, WORDS, gl.UNSIGNED_INT, 0, 0);
    gl.bindVertexArray(null);
    return { model, parts, array, buffer, bytes: words.byteLength };
  }

  drop({ array, buffer }: Layer): void {
    this.#gl.deleteVertexArray(array);
    this.#gl.deleteBuffer(buffer);
  }

  draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, maxGrid: number): FrameCounts {
    const gl = this.#gl;
    const grid = gridOf(maxGrid, Math.max(camera.width, camera.height), this.#maxTextureSize);
    const sampled = { ...camera, width: camera.width * grid, height: camera.height * grid };
    const projector = projectorOf(sampled);
    const target = this.#targetOf(sampled.width, sampled.height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.frame);
    gl.viewport(0, 0, target.width, target.height);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.GREATER);
    gl.clearColor(0, 0, 0, 0);
    gl.clearDepth(0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const nearest = nearDistanceOf(items, meshes.length > 0);
    const triangles = this.meshes.draw(meshes, projector, nearest);
    gl.useProgram(this.#splats.program);
    this.#setCamera(this.#splats, projector);
    gl.uniform1f(this.#splats.at('nearest'), nearest);
    let [splats, calls] = [0, meshes.length];
    for (const item of items) {
      const drawn = this.#drawItem(item, projector);
      splats += drawn.splats;
      calls += drawn.calls;
    }
    gl.bindVertexArray(null);
    this.#show(target, projector, camera, grid);
    return { splats, triangles, calls };
  }

  get isDone(): boolean {
    const gl = this.#gl;
    if (this.#fence && gl.getSyncParameter(this.#fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
    gl.deleteSync(this.#fence);
    this.#fence = null;
    return true;
  }

  async finish(): Promise<void> {
    this.#gl.readPixels(0, 0, 1, 1, this.#gl.RGBA, this.#gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  #drawItem({ layer, box }: Item<Layer>, projector: Projector): Omit<FrameCounts, 'triangles'> {
    const gl = this.#gl;
    const sight = sightOf(layer.model, projector);
    const rows = rowsOf(layer.model, this.layout, box);
    const { width, height } = projector;
    const inBox = box ? layer.parts.filter((part) => mayLieIn(rows, part)) : layer.parts;
    const visible = inBox.filter((part) => boundsOf(sight, part, width, height));
    if (visible.length === 0) return { splats: 0, calls: 0 };
    writeView(this.#numbers, layer.model, sight, rows);
    gl.uniform4fv(this.#splats.at('view'), this.#numbers);
    gl.bindVertexArray(layer.array);
    let [splats, calls] = [0, 0];
    for (let n = 0; n < visible.length;) {
      const { first } = visible[n] as Part;
      let end = first;
      // Contiguous parts of the buffer are drawn by one call.
      for (; visible[n]?.first === end; n++) end += (visible[n] as Part).count;
      gl.drawArrays(gl.POINTS, first, end - first);
      splats += end - first;
      calls += 1;
    }
    return { splats, calls };
  }

  #setCamera(program: Program, { rows, rays, width, height }: Projector): void {
    const gl = this.#gl;
    gl.uniform3fv(program.at('gradients'), rows.flat());
    gl.uniform3fv(program.at('rays'), rays.flat());
    gl.uniform3f(program.at('screen'), width, height, this.#maxPointSize);
  }

  #show(target: Target, projector: Projector, { width, height }: Camera, grid: number): void {
    const gl = this.#gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(this.#resolve.program);
    this.#setCamera(this.#resolve, projector);
    gl.uniform1i(this.#resolve.at('grid'), grid);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, target.color);
    gl.uniform1i(this.#resolve.at('samples'), 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.deleteSync(this.#fence);
    this.#fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  #targetOf(width: number, height: number): Target {
    if (this.#target?.width !== width || this.#target.height !== height) {
      this.#target?.dispose();
      this.#target = targetOf(this.#gl, width, height);
    }
    return this.#target;
  }
}
