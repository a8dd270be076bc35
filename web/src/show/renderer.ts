/** Creates the renderer of three.js, watches for the loss of its context, and draws into a headset's framebuffer. */
import { WebGLRenderer } from 'three';
import { messageOf } from '../base/errors';
import { BundleError } from '../bundle/error';

/** Message while the graphics context is lost. */
export const GRAPHICS_LOST = 'The browser has reset the graphics. The picture returns as soon as they are restored.';
/** Greatest duration of a frame, seconds. A hidden tab has no frames; when it returns, movements do not jump ahead. */
export const MAX_FRAME_SECONDS = 0.1;

export function createRenderer(canvas: HTMLCanvasElement, antialias: boolean): WebGLRenderer {
  let renderer: WebGLRenderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias, powerPreference: 'high-performance' });
  } catch (error) {
    throw new BundleError(messageOf(error), 'webgl');
  }
  renderer.autoClear = false;
  // A composition layer of a headset lies behind the picture and is visible where alpha is 0.
  renderer.setClearAlpha(0);
  renderer.sortObjects = false;
  // The checks of three.js wait for the GPU; `programs.ts` checks shaders without a wait.
  renderer.debug.checkShaderErrors = false;
  return renderer;
}

/** Watches a canvas for the loss of its context. Must be called after three.js has added its own listeners. */
export function watchLoss(canvas: HTMLCanvasElement, handleLoss: () => void, handleRestoration: () => void) {
  let isLost = false;
  const stop = new AbortController();
  const { signal } = stop;
  canvas.addEventListener('webglcontextlost', (event) => {
    // Otherwise the browser does not restore the context.
    event.preventDefault();
    isLost = true;
    handleLoss();
  }, { signal });
  canvas.addEventListener('webglcontextrestored', () => {
    isLost = false;
    handleRestoration();
  }, { signal });
  return {
    get isLost(): boolean {
      return isLost;
    },
    dispose: (): void => stop.abort(),
  };
}

/**
 * Draws several scenes into the framebuffer of a headset before its samples are resolved. three.js otherwise resolves
 * after each scene and discards depth and colour. The next scene drawn after this call resolves the samples.
 */
export function resolveOnce(renderer: WebGLRenderer, draw: () => void): void {
  renderer.clear();
  const target = renderer.getRenderTarget();
  const samples = target?.samples ?? 0;
  if (target) target.samples = 0;
  draw();
  if (target) target.samples = samples;
}
