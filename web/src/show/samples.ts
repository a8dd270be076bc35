/** The framebuffer of a headset has several samples a pixel, which are resolved once a frame. */
import type { WebGLRenderer } from 'three';

/**
 * Draw into the framebuffer of a headset several times before its samples are resolved, which three.js does after each
 * scene and then lets go of their depth and colour. The next scene resolves them.
 */
export function resolveOnce(renderer: WebGLRenderer, draw: () => void): void {
  renderer.clear();
  const target = renderer.getRenderTarget();
  const samples = target?.samples ?? 0;
  if (target) target.samples = 0;
  draw();
  if (target) target.samples = samples;
}
