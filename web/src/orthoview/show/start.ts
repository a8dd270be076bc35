/** Chooses what draws. */
import { WebglDrawer } from '../draw/webgl/drawer';
import { deviceOf } from '../draw/webgpu/device';
import type { WebgpuDrawer } from '../draw/webgpu/drawer';
import type { Layout } from '../store/layout';
import { type Stock, stockOf } from './stock';

export type Graphics = 'webgl' | 'webgpu';

export interface StartSettings {
  /** The graphics that draw; null for WebGPU where it is, else WebGL 2. */
  readonly graphics: Graphics | null;
  /** The script that draws by WebGPU, which is read where it is used. */
  readonly script: URL;
  /** Bytes of views. */
  readonly bytes: number;
  /** The graphics are gone, if that is fatal, or have too little memory. */
  failed(message: string, isFatal: boolean): void;
}

/** A stock of a tree that is drawn on a canvas. */
export async function startStock(
  canvas: HTMLCanvasElement,
  layout: Layout,
  { graphics, script, bytes, failed }: StartSettings,
): Promise<{ readonly stock: Stock; readonly graphics: Graphics }> {
  const webgpu = graphics === 'webgl' ? null : await startWebgpu(canvas, layout, graphics === 'webgpu', script, failed);
  if (webgpu) return { stock: stockOf(layout, webgpu, bytes), graphics: 'webgpu' };
  return { stock: stockOf(layout, new WebglDrawer(canvas, layout), bytes), graphics: 'webgl' };
}

/** A drawer by WebGPU; null where it cannot be had, unless it was asked for by name. */
async function startWebgpu(
  canvas: HTMLCanvasElement,
  layout: Layout,
  isNamed: boolean,
  script: URL,
  failed: StartSettings['failed'],
): Promise<WebgpuDrawer | null> {
  try {
    const device = await deviceOf(isNamed);
    if (device) {
      const { start }: typeof import('../draw/webgpu/start') = await import(script.href);
      return await start(canvas, layout, device, failed);
    }
    if (isNamed) throw new Error('this browser has no WebGPU');
  } catch (reason) {
    if (isNamed) throw reason;
    console.warn('nearfar: WebGL draws, because WebGPU fails:', reason);
  }
  return null;
}
