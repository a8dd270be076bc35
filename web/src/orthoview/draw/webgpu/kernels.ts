/** Pipelines that draw splats, the layouts of their bindings, and the uniforms of their calls. */
import type { Projector } from '../projection';
import { UNIFORM_STRIDE } from './buffers';
import { BEGIN, RESOLVE } from './sample_shaders';
import type { Band } from './samples';
import { SPLATS } from './splat_shaders';

export type Kernels = ReturnType<typeof kernelsOf>;

/** Creates the pipelines for canvases of a format. */
export function kernelsOf(device: GPUDevice, format: GPUTextureFormat) {
  /** Creates the layout of a bind group: uniforms at a dynamic offset, then other resources. */
  const layoutOf = (
    visibility: GPUShaderStageFlags,
    resources: readonly Omit<GPUBindGroupLayoutEntry, 'binding' | 'visibility'>[],
  ): GPUBindGroupLayout => {
    const all = [{ buffer: { hasDynamicOffset: true } }, ...resources];
    return device.createBindGroupLayout({ entries: all.map((entry, binding) => ({ binding, visibility, ...entry })) });
  };
  const { COMPUTE, FRAGMENT, VERTEX } = GPUShaderStage;
  const read = { buffer: { type: 'read-only-storage' as const } };
  const write = { buffer: { type: 'storage' as const } };
  const uniformLayout = layoutOf(VERTEX | FRAGMENT, []);
  const splatLayout = layoutOf(COMPUTE, [read, read, read, read, write, write, write]);
  const beginLayout = layoutOf(COMPUTE, [{ texture: { sampleType: 'depth' } }, write]);
  const resolveLayout = layoutOf(FRAGMENT, [{ texture: { sampleType: 'unfilterable-float' } }, read, read]);
  const moduleOf = (label: string, code: string): GPUShaderModule => device.createShaderModule({ label, code });
  const computePipeline = (layout: GPUBindGroupLayout, module: GPUShaderModule, entryPoint: string): GPUComputePipeline =>
    device.createComputePipeline({
      label: entryPoint,
      layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      compute: { module, entryPoint },
    });
  const [splatModule, resolveModule] = [moduleOf('splats', SPLATS), moduleOf('resolve', RESOLVE)];
  return {
    uniformLayout,
    splatLayout,
    beginLayout,
    resolveLayout,
    splats: computePipeline(splatLayout, splatModule, 'splats'),
    tiles: computePipeline(splatLayout, splatModule, 'farthest_of_tiles'),
    shade: computePipeline(splatLayout, splatModule, 'shade'),
    begin: computePipeline(beginLayout, moduleOf('begin', BEGIN), 'begin'),
    resolve: device.createRenderPipeline({
      label: 'resolve',
      layout: device.createPipelineLayout({ bindGroupLayouts: [resolveLayout] }),
      vertex: { module: resolveModule },
      fragment: { module: resolveModule, targets: [{ format }] },
    }),
  };
}

/** Uniforms that are the same for all calls. */
export interface CommonUniforms {
  /** Projector into samples. */
  readonly projector: Projector;
  readonly grid: number;
  /** Near distance, metres. */
  readonly nearest: number;
  /** Number of all parts. */
  readonly parts: number;
}

export interface CallUniforms {
  /** The call draws parts [first, first + count). */
  readonly first?: number;
  readonly count?: number;
  readonly round?: number;
  /** Index of the page. */
  readonly page?: number;
}

/** Uniforms of all calls of a picture. */
export class Uniforms {
  readonly #data: ArrayBuffer;
  #used = 0;

  constructor(
    readonly common: CommonUniforms,
    /** Greatest number of calls. */
    calls: number,
  ) {
    this.#data = new ArrayBuffer(UNIFORM_STRIDE * calls);
  }

  get all(): Uint32Array<ArrayBuffer> {
    return new Uint32Array(this.#data);
  }

  /** Adds a call; returns the byte offset of its uniforms. */
  put(band: Band, { first = 0, count = 0, round = 0, page = 0 }: CallUniforms): number {
    const { projector, grid, nearest, parts } = this.common;
    const offset = UNIFORM_STRIDE * this.#used;
    const floats = new Float32Array(this.#data, offset, UNIFORM_STRIDE / 4);
    [...projector.rows, ...projector.rays].forEach((vector, n) => floats.set(vector, 4 * n));
    new Uint32Array(this.#data, offset + 96, 12).set([
      ...[projector.width, band.rows, band.first, grid],
      ...[first, count, round, 0],
      ...[parts, page, 0, 0],
    ]);
    floats[36] = nearest;
    this.#used += 1;
    return offset;
  }
}
