/** Chooses what draws. */
import { WebglDrawer } from '../draw/webgl/drawer';
import { deviceOf } from '../draw/webgpu/device';
import { WebgpuDrawer } from '../draw/webgpu/drawer';
import type { Layout } from '../store/layout';
import { type Stock, stockOf } from './stock';

export type Graphics = 'webgl' | 'webgpu';

export interface StartSettings {
  /** What draws; null for WebGPU where it is, else WebGL 2. */
  readonly graphics: Graphics | null;
  /** Bytes of views. */
  readonly bytes: number;
  /** The graphics are gone, or cannot go on. */
  failed(message: string): void;
}

/** A stock of a tree that is drawn on a canvas. */
export async function startStock(
  canvas: HTMLCanvasElement,
  layout: Layout,
  { graphics, bytes, failed }: StartSettings,
): Promise<{ readonly stock: Stock; readonly graphics: Graphics }> {
  const device = graphics === 'webgl' ? null : await deviceOf(graphics === 'webgpu');
  if (device) {
    const drawer = new WebgpuDrawer(canvas, layout, device, failed);
    return { stock: stockOf(layout, drawer, bytes), graphics: 'webgpu' };
  }
  if (graphics === 'webgpu') throw new Error('this browser has no WebGPU');
  return { stock: stockOf(layout, new WebglDrawer(canvas, layout), bytes), graphics: 'webgl' };
}
