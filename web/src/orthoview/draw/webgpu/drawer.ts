/** Draws views with WebGPU: compute shaders find the nearest depth of each sample, then its splat and colour. */
import type { Camera } from '../../cut/camera';
import type { Part } from '../../decode/pack';
import type { Layout } from '../../store/layout';
import { type Drawer, type FrameCounts, gridOf, type Item, nearDistanceOf } from '../drawer';
import { type Model, type Projector, projectorOf } from '../projection';
import { Arena, GrowingBuffer, type Page, type PageRange, UNIFORM_STRIDE } from './buffers';
import { type CallUniforms, type Kernels, Uniforms } from './kernels';
import { COLOR, type Mesh, type Meshes } from './meshes';
import { GROUP, ROW } from './sample_shaders';
import { type Band, bandsOf, createSamples, type Targets, tilesOf } from './samples';
import { type Work, workOf } from './work';

/** Layer of a view on the GPU. */
export interface Layer extends PageRange {
  readonly model: Model;
  readonly parts: readonly Part[];
}

interface Picture {
  readonly encoder: GPUCommandEncoder;
  readonly meshes: readonly Mesh[];
  /** Projector into samples. */
  readonly projector: Projector;
  readonly grid: number;
  /** Greatest number of rows in a band. */
  readonly rows: number;
  readonly work: Work<Page>;
  readonly uniforms: Uniforms;
  /** Uniforms of one call, selected by a dynamic offset. */
  readonly uniformBinding: GPUBufferBinding;
  readonly views: GPUBuffer;
  readonly parts: GPUBuffer;
  readonly partOrder: GPUBuffer;
  readonly target: GPUTextureView;
}

/** Creates a drawer for a canvas that has the format of the kernels. */
export function createWebgpuDrawer(
  context: GPUCanvasContext,
  layout: Layout,
  device: GPUDevice,
  kernels: Kernels,
  meshDrawer: Meshes,
): Drawer<Layer, Mesh> {
  const arena = new Arena(device);
  const samples = createSamples(device);
  const uniformBuffer = new GrowingBuffer(device, 'calls', GPUBufferUsage.UNIFORM);
  const storage = (label: string): GrowingBuffer => new GrowingBuffer(device, label, GPUBufferUsage.STORAGE);
  const [viewBuffer, partBuffer, listBuffer] = [storage('views'), storage('parts'), storage('partOrder')];
  /** Stands in for the colours of geometry in pictures without geometry. */
  const emptyTexture = device.createTexture({ size: [1, 1], format: COLOR, usage: GPUTextureUsage.TEXTURE_BINDING });
  let done: Promise<void> = Promise.resolve();
  /** Number of submitted pictures that are not finished. */
  let unfinished = 0;
  let drawnSplats: number | null = null;

  function draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, maxGrid: number): FrameCounts {
    const grid = gridOf(maxGrid, camera.width, device.limits.maxTextureDimension2D);
    const projector = projectorOf({ ...camera, width: camera.width * grid, height: camera.height * grid });
    const nearest = nearDistanceOf(items, meshes.length > 0);
    const work = workOf(items, projector, layout, nearest);
    const bands = bandsOf(device, projector.width, projector.height, grid);
    const calls = bands.length * (1 + 4 * work.calls.length + work.pages.length);
    const encoder = device.createCommandEncoder();
    const picture: Picture = {
      encoder,
      meshes,
      projector,
      grid,
      rows: bands[0]?.rows ?? 0,
      work,
      uniforms: new Uniforms({ projector, grid, nearest, parts: work.partOrder.length }, calls),
      uniformBinding: { buffer: uniformBuffer.reserve(UNIFORM_STRIDE * calls), size: UNIFORM_STRIDE },
      views: viewBuffer.write(work.views),
      parts: partBuffer.write(work.parts),
      partOrder: listBuffer.write(work.partOrder),
      target: context.getCurrentTexture().createView(),
    };
    let triangles = 0;
    for (const band of bands) triangles = drawBand(picture, band);
    uniformBuffer.write(picture.uniforms.all);
    submit(encoder, bands);
    const callsPerBand = 2 * work.calls.length + work.pages.length + meshes.length;
    return { splats: work.splats, triangles, calls: bands.length * callsPerBand };
  }

  /** Records the commands of a band; returns the number of triangles of its geometry. */
  function drawBand(picture: Picture, band: Band): number {
    const { encoder, meshes, projector } = picture;
    const bytes = 4 * projector.width * band.rows;
    const { depthBits, colors, tiles } = samples.buffers(projector.width, band.rows);
    const targets = meshes.length > 0 ? samples.targets(projector.width, picture.rows) : null;
    if (band.number === 0) encoder.clearBuffer(tiles, 0, 4);
    encoder.clearBuffer(colors, 0, bytes);
    const slot = picture.uniforms.put(band, {});
    let triangles = 0;
    if (targets) {
      triangles = drawMeshes(picture, band, slot, targets);
      const resources = [picture.uniformBinding, targets.depth.createView(), { buffer: depthBits }];
      const pass = encoder.beginComputePass({ label: 'begin' });
      pass.setPipeline(kernels.begin);
      pass.setBindGroup(0, createGroup(kernels.beginLayout, resources), [slot]);
      dispatch(pass, Math.ceil((projector.width * band.rows) / GROUP));
      pass.end();
    } else encoder.clearBuffer(depthBits, 0, bytes);
    drawSplats(picture, band, [{ buffer: tiles }, { buffer: depthBits }, { buffer: colors }]);
    const geometry = (targets?.color ?? emptyTexture).createView();
    const resources = [picture.uniformBinding, geometry, { buffer: depthBits }, { buffer: colors }];
    show(picture, band, slot, createGroup(kernels.resolveLayout, resources));
    return triangles;
  }

  function drawMeshes(picture: Picture, { rows }: Band, slot: number, { color, depth }: Targets): number {
    const { encoder, meshes, projector, uniformBinding } = picture;
    const view = depth.createView();
    const pass = encoder.beginRenderPass({
      label: 'meshes',
      colorAttachments: [{ view: color.createView(), loadOp: 'clear', storeOp: 'store' }],
      depthStencilAttachment: { view, depthClearValue: 0, depthLoadOp: 'clear', depthStoreOp: 'store' },
    });
    pass.setViewport(0, 0, projector.width, rows, 0, 1);
    pass.setBindGroup(0, createGroup(kernels.uniformLayout, [uniformBinding]), [slot]);
    const triangles = meshDrawer.record(pass, meshes, projector.eye);
    pass.end();
    return triangles;
  }

  /**
   * Round 0 finds the samples' depths, nearest parts first; round 1 finds the splats at these depths. Both skip
   * occluded parts. Then the splats are shaded.
   */
  function drawSplats(picture: Picture, band: Band, outputs: readonly GPUBindingResource[]): void {
    const { encoder, projector, work, uniforms, uniformBinding, views, parts, partOrder } = picture;
    const groups = new Map<Page, GPUBindGroup>();
    for (const page of work.pages) {
      const inputs = [views, parts, partOrder, page.buffer].map((buffer) => ({ buffer }));
      groups.set(page, createGroup(kernels.splatLayout, [uniformBinding, ...inputs, ...outputs]));
    }
    const pass = encoder.beginComputePass({ label: 'splats' });
    const call = (pipeline: GPUComputePipeline, page: Page, count: number, parameters: CallUniforms): void => {
      pass.setPipeline(pipeline);
      pass.setBindGroup(0, groups.get(page) as GPUBindGroup, [uniforms.put(band, parameters)]);
      dispatch(pass, count);
    };
    const { splats, tiles, shade } = kernels;
    const groupsOfTiles = Math.ceil(tilesOf(projector.width, band.rows) / GROUP);
    for (const round of [0, 1]) {
      for (const [n, each] of work.calls.entries()) {
        if (each.startsBatch && (round === 0 || n === 0)) call(tiles, each.page, groupsOfTiles, {});
        call(splats, each.page, each.count, { first: each.first, count: each.count, round });
      }
    }
    const groupsOfSamples = Math.ceil((projector.width * band.rows) / GROUP);
    for (const [number, page] of work.pages.entries()) call(shade, page, groupsOfSamples, { page: number });
    pass.end();
  }

  function show(picture: Picture, { number, first, rows }: Band, slot: number, group: GPUBindGroup): void {
    const { encoder, projector, grid, target } = picture;
    const attachment = { view: target, loadOp: number === 0 ? 'clear' : 'load', storeOp: 'store' } as const;
    const pass = encoder.beginRenderPass({ label: 'show', colorAttachments: [attachment] });
    pass.setPipeline(kernels.resolve);
    pass.setBindGroup(0, group, [slot]);
    pass.setScissorRect(0, first / grid, projector.width / grid, rows / grid);
    pass.draw(3);
    pass.end();
  }

  function submit(encoder: GPUCommandEncoder, bands: readonly Band[]): void {
    const count = device.createBuffer({ size: 4, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
    if (bands.length > 0) encoder.copyBufferToBuffer(samples.counts, 0, count, 0, 4);
    device.queue.submit([encoder.finish()]);
    unfinished += 1;
    const read = (): void => {
      drawnSplats = new Uint32Array(count.getMappedRange())[0] ?? 0;
      count.destroy();
    };
    // The device reports its loss itself.
    done = count.mapAsync(GPUMapMode.READ).then(read, () => undefined).finally(() => (unfinished -= 1));
  }

  function createGroup(layout: GPUBindGroupLayout, resources: readonly GPUBindingResource[]): GPUBindGroup {
    const entries = resources.map((resource, binding) => ({ binding, resource }));
    return device.createBindGroup({ layout, entries });
  }

  return {
    upload: (model, { words, parts }) => ({ model, parts, ...arena.put(words) }),
    drop: (layer) => arena.free(layer),
    meshes: meshDrawer,
    draw,
    get isDone() {
      return unfinished === 0;
    },
    finish: () => done,
    get drawnSplats() {
      return drawnSplats;
    },
  };
}

/** Dispatches workgroups as a grid, because the length of a row is limited. */
function dispatch(pass: GPUComputePassEncoder, groups: number): void {
  pass.dispatchWorkgroups(Math.min(groups, ROW), Math.ceil(groups / ROW));
}
