import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { WebGLRenderer } from 'three';
import type { Cube } from '../src/show/textures';
import { createMapLayer } from '../src/xr/layer';

/** Creates a renderer in a headset with layers, and a function that returns the number of copied faces. */
function createFakeRenderer(): { renderer: WebGLRenderer; countCopies: () => number } {
  let copies = 0;
  const layer = { needsRedraw: false };
  const session = { enabledFeatures: ['layers'], renderState: { layers: [layer] }, updateRenderState: () => undefined };
  const binding = {
    createCubeLayer: () => layer,
    getSubImage: () => ({ colorTexture: {} }),
  };
  const gl = new Proxy({ blitFramebuffer: () => void (copies += 1) } as Record<string, unknown>, {
    get: (target, name: string) => target[name] ?? (() => null),
  });
  const renderer = {
    xr: {
      getSession: () => session,
      getReferenceSpace: () => ({}),
      getBinding: () => binding,
      getBaseLayer: () => ({}),
      getFrame: () => ({}),
    },
    getContext: () => gl,
    properties: { get: () => ({ __webglTexture: {} }) },
  };
  return { renderer: renderer as unknown as WebGLRenderer, countCopies: () => copies };
}

test('a layer shows full-size maps, and no coarse ones', () => {
  Object.assign(globalThis, { DOMPointReadOnly: class {} });
  const { renderer, countCopies } = createFakeRenderer();
  const layer = createMapLayer(renderer, 1024);
  const cube = (size: number): Cube => ({ size, ringShown: 0, color: {} }) as unknown as Cube;
  assert.equal(layer?.show(cube(512), 0), false);
  assert.equal(countCopies(), 0);
  layer?.show(cube(1024), 0);
  assert.equal(countCopies(), 6);
});
