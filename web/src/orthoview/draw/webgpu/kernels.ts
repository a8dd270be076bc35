/** Pipelines of splats, and how their resources are bound. */
import { BEGIN, RESOLVE, SPLATS } from './splat_shaders';

export interface Kernels {
  /** Of the numbers of a call, alone. */
  readonly draw: GPUBindGroupLayout;
  readonly work: GPUBindGroupLayout;
  readonly begun: GPUBindGroupLayout;
  readonly resolved: GPUBindGroupLayout;
  readonly splats: GPUComputePipeline;
  readonly tiles: GPUComputePipeline;
  readonly shade: GPUComputePipeline;
  readonly begin: GPUComputePipeline;
  readonly resolve: GPURenderPipeline;
}

/** The pipelines of a device for a canvas of a format. */
export function kernelsOf(device: GPUDevice, format: GPUTextureFormat): Kernels {
  const layoutOf = (
    visibility: GPUShaderStageFlags,
    resources: readonly Omit<GPUBindGroupLayoutEntry, 'binding' | 'visibility'>[],
  ): GPUBindGroupLayout => {
    const all = [{ buffer: { hasDynamicOffset: true } }, ...resources];
    const entries = all.map((resource, binding) => ({ binding, visibility, ...resource }));
    return device.createBindGroupLayout({ entries });
  };
  const { COMPUTE, FRAGMENT, VERTEX } = GPUShaderStage;
  const read = { buffer: { type: 'read-only-storage' as const } };
  const write = { buffer: { type: 'storage' as const } };
  const draw = layoutOf(VERTEX | FRAGMENT, []);
  const work = layoutOf(COMPUTE, [read, read, read, read, write, write, write]);
  const begun = layoutOf(COMPUTE, [{ texture: { sampleType: 'depth' } }, write]);
  const resolved = layoutOf(FRAGMENT, [{ texture: { sampleType: 'unfilterable-float' } }, read, read]);
  const moduleOf = (label: string, code: string): GPUShaderModule => device.createShaderModule({ label, code });
  const computed = (layout: GPUBindGroupLayout, module: GPUShaderModule, entryPoint: string): GPUComputePipeline =>
    device.createComputePipeline({
      label: entryPoint,
      layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      compute: { module, entryPoint },
    });
  const [splats, shown] = [moduleOf('splats', SPLATS), moduleOf('resolve', RESOLVE)];
  return {
    draw,
    work,
    begun,
    resolved,
    splats: computed(work, splats, 'splats'),
    tiles: computed(work, splats, 'farthest_of_tiles'),
    shade: computed(work, splats, 'shade'),
    begin: computed(begun, moduleOf('begin', BEGIN), 'begin'),
    resolve: device.createRenderPipeline({
      label: 'resolve',
      layout: device.createPipelineLayout({ bindGroupLayouts: [resolved] }),
      vertex: { module: shown },
      fragment: { module: shown, targets: [{ format }] },
    }),
  };
}
