/** Parts of WebGPU that TypeScript's own type declarations lack. */
type Flags<Name extends string> = Readonly<Record<Name, number>>;

declare const GPUBufferUsage: Flags<'COPY_DST' | 'COPY_SRC' | 'INDEX' | 'MAP_READ' | 'STORAGE' | 'UNIFORM' | 'VERTEX'>;
declare const GPUMapMode: Flags<'READ'>;
declare const GPUShaderStage: Flags<'COMPUTE' | 'FRAGMENT' | 'VERTEX'>;
declare const GPUTextureUsage: Flags<'COPY_DST' | 'RENDER_ATTACHMENT' | 'TEXTURE_BINDING'>;

interface HTMLCanvasElement {
  getContext(name: 'webgpu'): GPUCanvasContext | null;
}
