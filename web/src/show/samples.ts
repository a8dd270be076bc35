/** Multisampled framebuffer of a headset, resolved once per frame. */
import type { WebGLRenderer } from 'three';

/**
 * Draws several scenes into the framebuffer of a headset before its samples are resolved. three.js otherwise resolves
 * after each scene and discards depth and colour. The next scene resolves the samples.
 */
export function resolveOnce(renderer: WebGLRenderer, draw: () => void): void {
  renderer.clear();
  const target = renderer.getRenderTarget();
  const samples = target?.samples ?? 0;
  if (target) target.samples = 0;
  draw();
  if (target) target.samples = samples;
}
