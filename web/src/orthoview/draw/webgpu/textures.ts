/** Textures with all mipmap levels. */
import { LEVEL } from './mesh_shaders';

const FORMAT: GPUTextureFormat = 'rgba8unorm-srgb';

export class Images {
  readonly #pipeline: GPURenderPipeline;
  readonly #sampler: GPUSampler;
  /** White texture of one texel, for materials without an image. */
  readonly white: GPUTexture;

  constructor(readonly device: GPUDevice) {
    const module = device.createShaderModule({ label: 'levels of textures', code: LEVEL });
    this.#pipeline = device.createRenderPipeline({
      label: 'levels of textures',
      layout: 'auto',
      vertex: { module },
      fragment: { module, targets: [{ format: FORMAT }] },
    });
    this.#sampler = device.createSampler({ minFilter: 'linear', magFilter: 'linear' });
    this.white = this.#empty(1, 1);
    device.queue.writeTexture({ texture: this.white }, new Uint8Array([255, 255, 255, 255]), {}, [1, 1]);
  }

  /** Creates the texture of an image and closes the image. */
  of(image: ImageBitmap): GPUTexture {
    const { width, height } = image;
    const texture = this.#empty(width, height);
    this.device.queue.copyExternalImageToTexture({ source: image }, { texture }, [width, height]);
    image.close();
    const encoder = this.device.createCommandEncoder();
    for (let level = 1; level < texture.mipLevelCount; level++) this.#fill(encoder, texture, level);
    this.device.queue.submit([encoder.finish()]);
    return texture;
  }

  #empty(width: number, height: number): GPUTexture {
    return this.device.createTexture({
      label: 'image',
      size: [width, height],
      format: FORMAT,
      mipLevelCount: 1 + Math.floor(Math.log2(Math.max(width, height))),
      usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST | GPUTextureUsage.RENDER_ATTACHMENT,
    });
  }

  #fill(encoder: GPUCommandEncoder, texture: GPUTexture, level: number): void {
    const view = (baseMipLevel: number): GPUTextureView => texture.createView({ baseMipLevel, mipLevelCount: 1 });
    const pass = encoder.beginRenderPass({
      colorAttachments: [{ view: view(level), loadOp: 'clear', storeOp: 'store' }],
    });
    pass.setPipeline(this.#pipeline);
    const entries = [
      { binding: 0, resource: view(level - 1) },
      { binding: 1, resource: this.#sampler },
    ];
    pass.setBindGroup(0, this.device.createBindGroup({ layout: this.#pipeline.getBindGroupLayout(0), entries }));
    pass.draw(3);
    pass.end();
  }
}
