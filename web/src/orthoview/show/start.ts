/** Choice of the graphics back end, and of the WebGPU device. */
import { createWebglDrawer } from '../draw/webgl/drawer';
import type { Layout } from '../store/layout';
import { createResidentTree, type Graphics } from './resident';

export interface StartSettings {
  /** Requested back end; null for WebGPU if available, else WebGL 2. */
  readonly graphics: Graphics | null;
  /** Script of the WebGPU back end, loaded on demand. */
  readonly script: URL;
  /** Greatest size of the views on the GPU, bytes. */
  readonly maxViewBytes: number;
  /** Called if the graphics fail: fatal if the device is lost, not fatal if memory is short. */
  onFailure(message: string, isFatal: boolean): void;
}

/** Creates the resident part of a tree that is drawn on a canvas. */
export async function startResidentTree(canvas: HTMLCanvasElement, layout: Layout, settings: StartSettings) {
  const { graphics, maxViewBytes } = settings;
  const webgpu = graphics === 'webgl' ? null : await startWebgpu(canvas, layout, graphics === 'webgpu', settings);
  if (webgpu) return { resident: createResidentTree(layout, webgpu, maxViewBytes), graphics: 'webgpu' as Graphics };
  const webgl = createWebglDrawer(canvas, layout);
  return { resident: createResidentTree(layout, webgl, maxViewBytes), graphics: 'webgl' as Graphics };
}

/** Returns a WebGPU drawer; if none is available, throws if WebGPU was requested by name, and else returns null. */
async function startWebgpu(canvas: HTMLCanvasElement, layout: Layout, isNamed: boolean, settings: StartSettings) {
  try {
    const device = await deviceOf(isNamed);
    if (device) {
      const { start }: typeof import('../draw/webgpu/start') = await import(settings.script.href);
      return await start(canvas, layout, device, settings.onFailure);
    }
    if (isNamed) throw new Error('this browser has no WebGPU');
  } catch (reason) {
    if (isNamed) throw reason;
    console.warn('nearfar: WebGPU fails, so WebGL draws:', reason);
  }
  return null;
}

/** Limits raised to those of the adapter, because all samples and views of a picture lie in a few buffers. */
const RAISED_LIMITS = ['maxBufferSize', 'maxStorageBufferBindingSize', 'maxTextureDimension2D'] as const;

/** Returns a device; null if there is none, or only a software renderer and WebGPU was not requested by name. */
export async function deviceOf(isNamed: boolean): Promise<GPUDevice | null> {
  const adapter = await navigator.gpu?.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter || (isSoftware(adapter) && !isNamed)) return null;
  const requiredLimits = Object.fromEntries(RAISED_LIMITS.map((name) => [name, adapter.limits[name]]));
  return adapter.requestDevice({ requiredLimits });
}

/** Whether an adapter is a software renderer; older browsers have the flag on the adapter itself. */
function isSoftware(adapter: GPUAdapter & { readonly isFallbackAdapter?: boolean }): boolean {
  return adapter.info?.isFallbackAdapter ?? adapter.isFallbackAdapter ?? false;
}
