/** Draws views with WebGL 2: splats as points into a sample buffer, which is then averaged into the canvas. */
import type { Camera } from '../../cut/camera';
import { type Part, type Splats, WORDS } from '../../decode/pack';
import type { Layout } from '../../store/layout';
import { type Drawer, type FrameCounts, gridOf, type Item, nearDistanceOf } from '../drawer';
import type { Model, Projector } from '../projection';
import { boundsOf, boxFunctionsOf, mayLieIn, projectorOf, projectView } from '../projection';
import { VECTORS_PER_VIEW, writeView } from '../projection';
import { type Program, programOf, type Target, targetOf } from './gl';
import { createMeshes, type Mesh } from './meshes';
import { RESOLVE_FRAGMENT, SPLAT_FRAGMENT, SPLAT_VERTEX, FULL_SCREEN_VERTEX } from './shaders';

/** A layer of a view on the GPU. */
export interface Layer {
  readonly model: Model;
  readonly parts: readonly Part[];
  readonly array: WebGLVertexArrayObject;
  readonly buffer: WebGLBuffer;
  readonly bytes: number;
}

export function createWebglDrawer(canvas: HTMLCanvasElement, layout: Layout): Drawer<Layer, Mesh> {
  const gl = canvas.getContext('webgl2', { alpha: false, antialias: false, depth: false }) as WebGL2RenderingContext;
  if (!gl) throw new Error('this browser has no WebGL 2');
  const splatProgram = programOf(gl, SPLAT_VERTEX, SPLAT_FRAGMENT);
  const resolveProgram = programOf(gl, FULL_SCREEN_VERTEX, RESOLVE_FRAGMENT);
  const meshDrawer = createMeshes(gl);
  const numbers = new Float32Array(4 * VECTORS_PER_VIEW);
  const maxPointSize = (gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE) as Float32Array)[1] ?? 1;
  const maxTextureSize = gl.getParameter(gl.MAX_TEXTURE_SIZE) as number;
  let target: Target | null = null;
  let fence: WebGLSync | null = null;

  function upload(model: Model, { words, parts }: Splats): Layer {
    const [array, buffer] = [gl.createVertexArray(), gl.createBuffer()];
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, words, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribIPointer(0, WORDS, gl.UNSIGNED_INT, 0, 0);
    gl.bindVertexArray(null);
    return { model, parts, array, buffer, bytes: words.byteLength };
  }

  function draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, maxGrid: number): FrameCounts {
    const grid = gridOf(maxGrid, Math.max(camera.width, camera.height), maxTextureSize);
    const sampled = { ...camera, width: camera.width * grid, height: camera.height * grid };
    const projector = projectorOf(sampled);
    const { frame, color } = prepareTarget(sampled.width, sampled.height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.viewport(0, 0, sampled.width, sampled.height);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.GREATER);
    gl.clearColor(0, 0, 0, 0);
    gl.clearDepth(0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const nearest = nearDistanceOf(items, meshes.length > 0);
    const triangles = meshDrawer.draw(meshes, projector, nearest);
    gl.useProgram(splatProgram.program);
    setCamera(splatProgram, projector);
    gl.uniform1f(splatProgram.at('nearest'), nearest);
    let [splats, calls] = [0, meshes.length];
    for (const item of items) {
      const drawn = drawItem(item, projector);
      splats += drawn.splats;
      calls += drawn.calls;
    }
    gl.bindVertexArray(null);
    show(color, projector, camera, grid);
    return { splats, triangles, calls };
  }

  function drawItem({ layer, box }: Item<Layer>, projector: Projector): Omit<FrameCounts, 'triangles'> {
    const projected = projectView(layer.model, projector);
    const boxFunctions = boxFunctionsOf(layer.model, layout, box);
    const { width, height } = projector;
    const inBox = box ? layer.parts.filter((part) => mayLieIn(boxFunctions, part)) : layer.parts;
    const visible = inBox.filter((part) => boundsOf(projected, part, width, height));
    if (visible.length === 0) return { splats: 0, calls: 0 };
    writeView(numbers, layer.model, projected, boxFunctions);
    gl.uniform4fv(splatProgram.at('view'), numbers);
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

  function setCamera(program: Program, { rows, rays, width, height }: Projector): void {
    gl.uniform3fv(program.at('gradients'), rows.flat());
    gl.uniform3fv(program.at('rays'), rays.flat());
    gl.uniform3f(program.at('screen'), width, height, maxPointSize);
  }

  function show(samples: WebGLTexture, projector: Projector, { width, height }: Camera, grid: number): void {
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(resolveProgram.program);
    setCamera(resolveProgram, projector);
    gl.uniform1i(resolveProgram.at('grid'), grid);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, samples);
    gl.uniform1i(resolveProgram.at('samples'), 0);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.deleteSync(fence);
    fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  function prepareTarget(width: number, height: number): Target {
    if (target?.width !== width || target.height !== height) {
      target?.dispose();
      target = targetOf(gl, width, height);
    }
    return target;
  }

  return {
    upload,
    drop({ array, buffer }) {
      gl.deleteVertexArray(array);
      gl.deleteBuffer(buffer);
    },
    meshes: meshDrawer,
    draw,
    get isDone() {
      if (fence && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
      gl.deleteSync(fence);
      fence = null;
      return true;
    },
    async finish() {
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    },
    drawnSplats: null,
  };
}
