/** Draws the geometry of near leaves with the depth and lighting of splats; creates textures with mipmaps. */
import type { Sampler } from '../../../decode/messages';
import { ROWS } from '../../../decode/placements';
import type { Piece } from '../../decode/leaf';
import type { Triple } from '../../store/layout';
import type { GpuResource } from '../drawer';
import { GrowingBuffer, UNIFORM_STRIDE } from './buffers';
import { LEVEL, MESHES } from './mesh_shaders';

/** Format of textures and of colour samples: linear light as 8-bit sRGB. */
export const COLOR = 'rgba8unorm-srgb';
/** Format of depth samples; nearer points have greater depths. */
export const DEPTH = 'depth32float';

/** Piece of geometry on the GPU. */
export interface Mesh extends GpuResource {
  readonly origin: Triple;
  readonly material: Piece['material'];
  readonly pipeline: GPURenderPipeline;
  /** Buffers of positions, normals, texture coordinates, colours and placements. */
  readonly buffers: readonly (GPUBuffer | null)[];
  readonly indices: GPUBuffer;
  readonly format: GPUIndexFormat;
  readonly corners: number;
  readonly instances: number;
  readonly textures: readonly (GPUTexture | null)[];
  readonly group: GPUBindGroup;
}

/** Formats and strides of the vertex arrays; the array of placements comes after them. */
const VERTEX_ARRAYS = [
  { format: 'float32x3', stride: 12 },
  { format: 'float32x3', stride: 12 },
  { format: 'float32x2', stride: 8 },
  { format: 'unorm16x4', stride: 8 },
] as const;
/** Address modes by the codes of glTF, and its code of the filter 'nearest'. */
const WRAPS: Readonly<Record<number, GPUAddressMode>> = { 10497: 'repeat', 33648: 'mirror-repeat', 33071: 'clamp-to-edge' };
const NEAREST = 9728;
/** Byte offset of zeros, which replace missing normals and texture coordinates. */
const ZEROS = 0;
/** Byte offset of white, which replaces missing colours. */
const WHITE = 12;

export type Meshes = ReturnType<typeof createMeshes>;

/** Creates the drawer of meshes; `uniformLayout` has one uniform buffer with a dynamic offset. */
export function createMeshes(device: GPUDevice, uniformLayout: GPUBindGroupLayout) {
  const module = device.createShaderModule({ label: 'meshes', code: MESHES });
  const visibility = GPUShaderStage.FRAGMENT;
  const resources = [{ texture: {} }, { texture: {} }, { sampler: {} }, { sampler: {} }];
  const layoutEntries = resources.map((resource, binding) => ({ binding, visibility, ...resource }));
  const texturesLayout = device.createBindGroupLayout({ entries: layoutEntries });
  const bindGroupLayouts = [uniformLayout, uniformLayout, texturesLayout];
  const layout = device.createPipelineLayout({ bindGroupLayouts });
  const textureStore = createTextures(device);
  const samplers = new Map<string, GPUSampler>();
  const standIns = bufferOf(new Uint32Array([0, 0, 0, 0xffffffff, 0xffffffff]), GPUBufferUsage.VERTEX);
  const pipelines = new Map<string, GPURenderPipeline>();
  const uniformBuffer = new GrowingBuffer(device, 'meshes', GPUBufferUsage.UNIFORM);
  // Compiled now, so that a browser that rejects the shaders reports it before anything is drawn.
  pipelineOf(true, true, true, true);

  function upload(piece: Piece): Mesh {
    const { positions, normals, uvs, colors, placements, indices } = piece;
    const buffers = [positions, normals, uvs, colors, placements].map((array) => {
      return array && bufferOf(array, GPUBufferUsage.VERTEX);
    });
    const images = [piece.image, piece.glow];
    const arrays = [...buffers, bufferOf(indices, GPUBufferUsage.INDEX)];
    let bytes = arrays.reduce((sum, buffer) => sum + (buffer?.size ?? 0), 0);
    // Mipmaps add a third.
    for (const image of images) bytes += image ? Math.ceil((16 * image.width * image.height) / 3) : 0;
    const textures = images.map((image) => image && textureStore.upload(image));
    return {
      origin: piece.origin,
      material: piece.material,
      pipeline: pipelineOf(true, normals !== null, uvs !== null, colors !== null),
      buffers,
      indices: arrays.at(-1) as GPUBuffer,
      format: indices instanceof Uint16Array ? 'uint16' : 'uint32',
      corners: indices.length,
      instances: placements.length / ROWS,
      textures,
      group: groupOf(textures, piece.material),
      bytes,
    };
  }

  function drop({ buffers, indices, textures }: Mesh): void {
    for (const resource of [...buffers, indices, ...textures]) resource?.destroy();
  }

  /** Draws meshes in a pass whose first bind group has the call's uniforms; returns the number of triangles. */
  function record(pass: GPURenderPassEncoder, meshes: readonly Mesh[], eye: Triple): number {
    const uniforms = new Float32Array((UNIFORM_STRIDE / 4) * meshes.length);
    meshes.forEach((mesh, n) => uniforms.set(uniformsOf(mesh, eye), (UNIFORM_STRIDE / 4) * n));
    const resource = { buffer: uniformBuffer.write(uniforms), size: UNIFORM_STRIDE };
    const group = device.createBindGroup({ layout: uniformLayout, entries: [{ binding: 0, resource }] });
    return meshes.reduce((sum, mesh, n) => {
      pass.setPipeline(mesh.pipeline);
      pass.setBindGroup(1, group, [UNIFORM_STRIDE * n]);
      pass.setBindGroup(2, mesh.group);
      mesh.buffers.forEach((buffer, slot) => {
        if (buffer) pass.setVertexBuffer(slot, buffer);
        else pass.setVertexBuffer(slot, standIns, slot === 3 ? WHITE : ZEROS);
      });
      pass.setIndexBuffer(mesh.indices, mesh.format);
      pass.drawIndexed(mesh.corners, mesh.instances);
      return sum + (mesh.corners / 3) * mesh.instances;
    }, 0);
  }

  function groupOf(textures: readonly (GPUTexture | null)[], material: Piece['material']): GPUBindGroup {
    const images = textures.map((texture) => (texture ?? textureStore.white).createView());
    const used = [material.imageSampler, material.glowSampler].map(samplerOf);
    const entries = [...images, ...used].map((resource, binding) => ({ binding, resource }));
    return device.createBindGroup({ layout: texturesLayout, entries });
  }

  function samplerOf(codes: Sampler): GPUSampler {
    const cached = samplers.get(codes.join());
    if (cached) return cached;
    const [wrapU, wrapV, filter] = codes;
    const sampler = device.createSampler({
      addressModeU: WRAPS[wrapU] ?? 'repeat',
      addressModeV: WRAPS[wrapV] ?? 'repeat',
      minFilter: 'linear',
      magFilter: filter === NEAREST ? 'nearest' : 'linear',
      mipmapFilter: 'linear',
    });
    samplers.set(codes.join(), sampler);
    return sampler;
  }

  /** Returns the pipeline for pieces that have these vertex arrays. */
  function pipelineOf(...hasArray: readonly boolean[]): GPURenderPipeline {
    const name = hasArray.join();
    const cached = pipelines.get(name);
    if (cached) return cached;
    const vertexBuffers = VERTEX_ARRAYS.map(({ format, stride }, shaderLocation) => ({
      // A stride of 0 gives all vertices the same value.
      arrayStride: hasArray[shaderLocation] ? stride : 0,
      attributes: [{ shaderLocation, offset: 0, format }],
    }));
    const rows = [0, 1, 2].map((row) => ({ shaderLocation: 4 + row, offset: 16 * row, format: 'float32x4' as const }));
    const instanceBuffer = { arrayStride: 4 * ROWS, stepMode: 'instance' as const, attributes: rows };
    const pipeline = device.createRenderPipeline({
      label: 'meshes',
      layout,
      vertex: { module, buffers: [...vertexBuffers, instanceBuffer] },
      fragment: { module, targets: [{ format: COLOR }] },
      depthStencil: { format: DEPTH, depthWriteEnabled: true, depthCompare: 'greater' },
    });
    pipelines.set(name, pipeline);
    return pipeline;
  }

  function bufferOf(data: ArrayBufferView, usage: GPUBufferUsageFlags): GPUBuffer {
    const size = 4 * Math.ceil(Math.max(data.byteLength, 4) / 4);
    const buffer = device.createBuffer({ label: 'mesh', size, usage, mappedAtCreation: true });
    new Uint8Array(buffer.getMappedRange()).set(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    buffer.unmap();
    return buffer;
  }

  return { upload, drop, record };
}

/** Uniforms of a mesh in the layout of the shader. */
function uniformsOf({ origin, material }: Mesh, eye: Triple): number[] {
  const { color, cutoff, emission, isUnlit } = material;
  // Computed in float64, because float32 is precise only near the eye.
  const offset = [origin[0] - eye[0], origin[1] - eye[1], origin[2] - eye[2]];
  return [...offset, cutoff ?? -1, ...color, ...(emission ?? [0, 0, 0]), isUnlit ? 1 : 0];
}

function createTextures(device: GPUDevice) {
  const module = device.createShaderModule({ label: 'mipmaps', code: LEVEL });
  const pipeline = device.createRenderPipeline({
    label: 'mipmaps',
    layout: 'auto',
    vertex: { module },
    fragment: { module, targets: [{ format: COLOR }] },
  });
  const sampler = device.createSampler({ minFilter: 'linear', magFilter: 'linear' });
  /** White texture of one texel, for materials without an image. */
  const white = createTexture(1, 1);
  device.queue.writeTexture({ texture: white }, new Uint8Array([255, 255, 255, 255]), {}, [1, 1]);

  /** Creates the texture of an image and closes the image. */
  function upload(image: ImageBitmap): GPUTexture {
    const { width, height } = image;
    const texture = createTexture(width, height);
    device.queue.copyExternalImageToTexture({ source: image }, { texture }, [width, height]);
    image.close();
    const encoder = device.createCommandEncoder();
    for (let level = 1; level < texture.mipLevelCount; level++) drawMipmap(encoder, texture, level);
    device.queue.submit([encoder.finish()]);
    return texture;
  }

  function createTexture(width: number, height: number): GPUTexture {
    return device.createTexture({
      label: 'image',
      size: [width, height],
      format: COLOR,
      mipLevelCount: 1 + Math.floor(Math.log2(Math.max(width, height))),
      usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST | GPUTextureUsage.RENDER_ATTACHMENT,
    });
  }

  function drawMipmap(encoder: GPUCommandEncoder, texture: GPUTexture, level: number): void {
    const view = (baseMipLevel: number): GPUTextureView => texture.createView({ baseMipLevel, mipLevelCount: 1 });
    const attachment = { view: view(level), loadOp: 'clear', storeOp: 'store' } as const;
    const pass = encoder.beginRenderPass({ colorAttachments: [attachment] });
    pass.setPipeline(pipeline);
    const entries = [{ binding: 0, resource: view(level - 1) }, { binding: 1, resource: sampler }];
    pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
    pass.draw(3);
    pass.end();
  }

  return { white, upload };
}
