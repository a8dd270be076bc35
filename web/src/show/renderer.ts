/** Renderer of three.js: its graphics context, which may be lost, and the multisampled framebuffer of a headset. */
import { WebGLRenderer } from 'three';
import { messageOf } from '../base/errors';
import { BundleError } from '../bundle/error';

/** Sentence for users whose graphics are lost, until they are restored. */
export const LOST = 'The browser has reset the graphics. The picture returns as soon as they are restored.';
/** Greatest duration of a frame in seconds: after a pause of a hidden tab the page continues where it was. */
export const LONGEST_FRAME = 0.1;

export function createRenderer(canvas: HTMLCanvasElement, antialias: boolean): WebGLRenderer {
  let renderer: WebGLRenderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias, powerPreference: 'high-performance' });
  } catch (error) {
    throw new BundleError(messageOf(error), 'webgl');
  }
  renderer.autoClear = false;
  // A composition layer of a headset lies below.
  renderer.setClearAlpha(0);
  renderer.sortObjects = false;
  // Checks block on the GPU; `programs` checks when that takes no time.
  renderer.debug.checkShaderErrors = false;
  return renderer;
}

export interface Loss {
  readonly isLost: boolean;
  /** Stops watching. */
  dispose(): void;
}

/** Watches a canvas; to be called after three.js has registered its own listeners. */
export function watchLoss(canvas: HTMLCanvasElement, lost: () => void, restored: () => void): Loss {
  let isLost = false;
  const stop = new AbortController();
  const { signal } = stop;
  const onLost = (event: Event): void => {
    // Otherwise the browser does not restore the context.
    event.preventDefault();
    isLost = true;
    lost();
  };
  const onRestored = (): void => {
    isLost = false;
    restored();
  };
  canvas.addEventListener('webglcontextlost', onLost, { signal });
  canvas.addEventListener('webglcontextrestored', onRestored, { signal });
  return {
    get isLost() {
      return isLost;
    },
    dispose: () => stop.abort(),
  };
}

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
