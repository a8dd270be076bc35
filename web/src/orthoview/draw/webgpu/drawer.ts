/** Draws views with WebGPU: compute shaders raise the depths of samples, and the nearest splats set their colours. */
import type { Camera } from '../../cut/camera';
import type { Part, Splats } from '../../decode/pack';
import type { Layout } from '../../store/layout';
import { type Drawer, type FrameCounts, gridOf, type Item, nearDistanceOf } from '../drawer';
import { type Model, type Projector, projectorOf } from '../sight';
import { Arena, type Page, type Place, GrowingBuffer, SLOT } from './buffers';
import { type Called, type Kernels, Numbers } from './kernels';
import { COLOR, type Mesh, type Meshes } from './meshes';
import { GROUP, ROW } from './sample_shaders';
import { type Band, bandsOf, createSamples, type Samples, type Targets, tilesOf } from './samples';
import { type Work, workOf } from './work';

/** Layer of a view on the GPU. */
export interface Layer extends Place {
  readonly model: Model;
  readonly parts: readonly Part[];
}

interface Picture {
  readonly meshes: readonly Mesh[];
  /** Projector of the samples. */
  readonly projector: Projector;
  readonly grid: number;
  /** Greatest number of rows of a band. */
  readonly rows: number;
  readonly work: Work<Page>;
  readonly numbers: Numbers;
  /** Uniforms of one call, selected by a dynamic offset. */
  readonly bound: GPUBufferBinding;
  readonly views: GPUBuffer;
  readonly parts: GPUBuffer;
  readonly listed: GPUBuffer;
  readonly target: GPUTextureView;
}

export class WebgpuDrawer implements Drawer<Layer, Mesh> {
  readonly #arena: Arena;
  readonly #samples: Samples;
  readonly #uniforms: GrowingBuffer;
  readonly #views: GrowingBuffer;
  readonly #parts: GrowingBuffer;
  readonly #listed: GrowingBuffer;
  /** Placeholder for the geometry of pictures without any. */
  readonly #nothing: GPUTexture;
  #done: Promise<void> = Promise.resolve();
  /** Number of submitted pictures that are not finished. */
  #unfinished = 0;
  unhidden: number | null = null;

  constructor(
    /** Context of a canvas, for the format of the kernels. */
    readonly context: GPUCanvasContext,
    readonly layout: Layout,
    readonly device: GPUDevice,
    readonly kernels: Kernels,
    readonly meshes: Meshes,
  ) {
    this.#arena = new Arena(device);
    this.#samples = createSamples(device);
    this.#uniforms = new GrowingBuffer(device, 'calls', GPUBufferUsage.UNIFORM);
    const storage = (label: string): GrowingBuffer => new GrowingBuffer(device, label, GPUBufferUsage.STORAGE);
    [this.#views, this.#parts, this.#listed] = [storage('views'), storage('parts'), storage('listed')];
    this.#nothing = device.createTexture({ size: [1, 1], format: COLOR, usage: GPUTextureUsage.TEXTURE_BINDING });
  }

  upload(model: Model, { words, parts }: Splats): Layer {
    return { model, parts, ...this.#arena.put(words) };
  }

  drop(layer: Layer): void {
    this.#arena.free(layer);
  }

  draw(meshes: readonly Mesh[], items: readonly Item<Layer>[], camera: Camera, maxGrid: number): FrameCounts {
    const grid = gridOf(maxGrid, camera.width, this.device.limits.maxTextureDimension2D);
    const projector = projectorOf({ ...camera, width: camera.width * grid, height: camera.height * grid });
    const nearest = nearDistanceOf(items, meshes.length > 0);
    const work = workOf(items, projector, this.layout, nearest);
    const bands = bandsOf(this.device, projector.width, projector.height, grid);
    const calls = bands.length * (1 + 4 * work.calls.length + work.pages.length);
    const picture: Picture = {
      meshes,
      projector,
      grid,
      rows: bands[0]?.rows ?? 0,
      work,
      numbers: new Numbers({ projector, grid, nearest, parts: work.listed.length }, calls),
      bound: { buffer: this.#uniforms.ofSize(SLOT * calls), size: SLOT },
      views: this.#views.with(work.views),
      parts: this.#parts.with(work.parts),
      listed: this.#listed.with(work.listed),
      target: this.context.getCurrentTexture().createView(),
    };
    const encoder = this.device.createCommandEncoder();
    let triangles = 0;
    for (const band of bands) triangles = this.#drawBand(encoder, picture, band);
    this.#uniforms.with(picture.numbers.all);
    this.#submit(encoder, bands);
    const callsPerBand = 2 * work.calls.length + work.pages.length + meshes.length;
    return { splats: work.splats, triangles, calls: bands.length * callsPerBand };
  }

  get isDone(): boolean {
    return this.#unfinished === 0;
  }

  finish(): Promise<void> {
    return this.#done;
  }

  /** Records the commands of a band; returns the number of triangles of its geometry. */
  #drawBand(encoder: GPUCommandEncoder, picture: Picture, band: Band): number {
    const { meshes, projector } = picture;
    const bytes = 4 * projector.width * band.rows;
    const { orders, colors, tiles } = this.#samples.buffers(projector.width, band.rows);
    const targets = meshes.length > 0 ? this.#samples.targets(projector.width, picture.rows) : null;
    if (band.number === 0) encoder.clearBuffer(tiles, 0, 4);
    encoder.clearBuffer(colors, 0, bytes);
    const slot = picture.numbers.put(band, {});
    let triangles = 0;
    if (targets) {
      triangles = this.#drawMeshes(encoder, picture, band, slot, targets);
      const resources = [picture.bound, targets.depth.createView(), { buffer: orders }];
      const pass = encoder.beginComputePass({ label: 'begin' });
      pass.setPipeline(this.kernels.begin);
      pass.setBindGroup(0, this.#createGroup(this.kernels.beginLayout, resources), [slot]);
      dispatch(pass, Math.ceil((projector.width * band.rows) / GROUP));
      pass.end();
    } else encoder.clearBuffer(orders, 0, bytes);
    this.#drawSplats(encoder, picture, band, [{ buffer: tiles }, { buffer: orders }, { buffer: colors }]);
    const geometry = (targets?.color ?? this.#nothing).createView();
    const resources = [picture.bound, geometry, { buffer: orders }, { buffer: colors }];
    this.#show(encoder, picture, band, slot, this.#createGroup(this.kernels.resolveLayout, resources));
    return triangles;
  }

  #drawMeshes(
    encoder: GPUCommandEncoder,
    { meshes, projector, bound }: Picture,
    { rows }: Band,
    slot: number,
    { color, depth }: Targets,
  ): number {
    const view = depth.createView();
    const pass = encoder.beginRenderPass({
      label: 'meshes',
      colorAttachments: [{ view: color.createView(), loadOp: 'clear', storeOp: 'store' }],
      depthStencilAttachment: { view, depthClearValue: 0, depthLoadOp: 'clear', depthStoreOp: 'store' },
    });
    pass.setViewport(0, 0, projector.width, rows, 0, 1);
    pass.setBindGroup(0, this.#createGroup(this.kernels.uniformLayout, [bound]), [slot]);
    const triangles = this.meshes.record(pass, meshes, projector.eye);
    pass.end();
    return triangles;
  }

  /** Draws the nearest parts first, so that occluded parts are culled; then the visible splats, and their light. */
  #drawSplats(
    encoder: GPUCommandEncoder,
    { projector, work, numbers, bound, views, parts, listed }: Picture,
    band: Band,
    found: readonly GPUBindingResource[],
  ): void {
    const groups = new Map<Page, GPUBindGroup>();
    for (const page of work.pages) {
      const inputs = [views, parts, listed, page.buffer].map((buffer) => ({ buffer }));
      groups.set(page, this.#createGroup(this.kernels.splatLayout, [bound, ...inputs, ...found]));
    }
    const pass = encoder.beginComputePass({ label: 'splats' });
    const call = (pipeline: GPUComputePipeline, page: Page, count: number, called: Called): void => {
      pass.setPipeline(pipeline);
      pass.setBindGroup(0, groups.get(page) as GPUBindGroup, [numbers.put(band, called)]);
      dispatch(pass, count);
    };
    const { splats, tiles, shade } = this.kernels;
    const groupsOfTiles = Math.ceil(tilesOf(projector.width, band.rows) / GROUP);
    for (const round of [0, 1]) {
      for (const [n, each] of work.calls.entries()) {
        if (each.begins && (round === 0 || n === 0)) call(tiles, each.page, groupsOfTiles, {});
        call(splats, each.page, each.count, { first: each.first, count: each.count, round });
      }
    }
    const groupsOfSamples = Math.ceil((projector.width * band.rows) / GROUP);
    for (const [number, page] of work.pages.entries()) call(shade, page, groupsOfSamples, { page: number });
    pass.end();
  }

  #show(
    encoder: GPUCommandEncoder,
    { projector, grid, target }: Picture,
    { number, first, rows }: Band,
    slot: number,
    group: GPUBindGroup,
  ): void {
    const attachment = { view: target, loadOp: number === 0 ? 'clear' : 'load', storeOp: 'store' } as const;
    const pass = encoder.beginRenderPass({ label: 'show', colorAttachments: [attachment] });
    pass.setPipeline(this.kernels.resolve);
    pass.setBindGroup(0, group, [slot]);
    pass.setScissorRect(0, first / grid, projector.width / grid, rows / grid);
    pass.draw(3);
    pass.end();
  }

  #submit(encoder: GPUCommandEncoder, bands: readonly Band[]): void {
    const count = this.device.createBuffer({ size: 4, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
    if (bands.length > 0) encoder.copyBufferToBuffer(this.#samples.counts, 0, count, 0, 4);
    this.device.queue.submit([encoder.finish()]);
    this.#unfinished += 1;
    const read = (): void => {
      this.unhidden = new Uint32Array(count.getMappedRange())[0] ?? 0;
      count.destroy();
    };
    // The device reports its loss itself.
    this.#done = count.mapAsync(GPUMapMode.READ).then(read, () => undefined).finally(() => (this.#unfinished -= 1));
  }

  #createGroup(layout: GPUBindGroupLayout, resources: readonly GPUBindingResource[]): GPUBindGroup {
    const entries = resources.map((resource, binding) => ({ binding, resource }));
    return this.device.createBindGroup({ layout, entries });
  }
}

/** Dispatches workgroups in rows, because the length of a row is limited. */
function dispatch(pass: GPUComputePassEncoder, groups: number): void {
  pass.dispatchWorkgroups(Math.min(groups, ROW), Math.ceil(groups / ROW));
}
