import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { WebGLRenderer } from 'three';
import type { Cube } from '../src/show/textures';
import { createMapLayer } from '../src/xr/layer';

/** A renderer in a headset with layers; `copies` counts copies into layers. */
function renderer(): { renderer: WebGLRenderer; copies: () => number } {
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
  const made = {
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
  return { renderer: made as unknown as WebGLRenderer, copies: () => copies };
}

test('coarse maps are drawn, because a layer has the texels of full maps', () => {
  Object.assign(globalThis, { DOMPointReadOnly: class {} });
  const { renderer: made, copies } = renderer();
  const layer = createMapLayer(made, 1024);
  const cube = (size: number): Cube => ({ size, holds: 0, color: {} }) as unknown as Cube;
  assert.equal(layer?.show(cube(512), 0), false);
  assert.equal(copies(), 0);
  layer?.show(cube(1024), 0);
  assert.equal(copies(), 6);
});
