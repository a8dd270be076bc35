/** Pipelines of splats and the layouts of their bindings. */
import { BEGIN, RESOLVE, SPLATS } from './splat_shaders';

export interface Kernels {
  /** Bind group layouts: uniforms at a dynamic offset, alone and together with the resources of each pipeline. */
  readonly numbered: GPUBindGroupLayout;
  readonly splatLayout: GPUBindGroupLayout;
  readonly beginLayout: GPUBindGroupLayout;
  readonly resolveLayout: GPUBindGroupLayout;
  readonly splats: GPUComputePipeline;
  readonly tiles: GPUComputePipeline;
  readonly shade: GPUComputePipeline;
  readonly begin: GPUComputePipeline;
  readonly resolve: GPURenderPipeline;
}

/** Creates the pipelines of a device for a canvas of a format. */
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
  const numbered = layoutOf(VERTEX | FRAGMENT, []);
  const splatLayout = layoutOf(COMPUTE, [read, read, read, read, write, write, write]);
  const beginLayout = layoutOf(COMPUTE, [{ texture: { sampleType: 'depth' } }, write]);
  const resolveLayout = layoutOf(FRAGMENT, [{ texture: { sampleType: 'unfilterable-float' } }, read, read]);
  const moduleOf = (label: string, code: string): GPUShaderModule => device.createShaderModule({ label, code });
  const computed = (layout: GPUBindGroupLayout, module: GPUShaderModule, entryPoint: string): GPUComputePipeline =>
    device.createComputePipeline({
      label: entryPoint,
      layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
      compute: { module, entryPoint },
    });
  const [splats, shown] = [moduleOf('splats', SPLATS), moduleOf('resolve', RESOLVE)];
  return {
    numbered,
    splatLayout,
    beginLayout,
    resolveLayout,
    splats: computed(splatLayout, splats, 'splats'),
    tiles: computed(splatLayout, splats, 'farthest_of_tiles'),
    shade: computed(splatLayout, splats, 'shade'),
    begin: computed(beginLayout, moduleOf('begin', BEGIN), 'begin'),
    resolve: device.createRenderPipeline({
      label: 'resolve',
      layout: device.createPipelineLayout({ bindGroupLayouts: [resolveLayout] }),
      vertex: { module: shown },
      fragment: { module: shown, targets: [{ format }] },
    }),
  };
}
