/**
 * The map as a composition layer of the headset (XRCubeLayer). The browser draws it behind near geometry, at the rate
 * and the resolution of the display.
 */
import type { WebGLRenderer } from 'three';
import type { MapLayer } from '../show/composer';
import { colorOf, type Cube, FACES } from '../show/textures';

/** Creates a layer behind the picture of the current session; null if the browser supports none. */
export function createMapLayer(renderer: WebGLRenderer, faceSize: number): MapLayer | null {
  const { xr } = renderer;
  const [session, space] = [xr.getSession(), xr.getReferenceSpace()];
  if (!session?.enabledFeatures?.includes('layers') || !space) return null;
  const binding: XRWebGLBinding = xr.getBinding();
  if (typeof binding.createCubeLayer !== 'function') return null;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const layer = binding.createCubeLayer({
    space,
    layout: 'mono',
    viewPixelWidth: faceSize,
    viewPixelHeight: faceSize,
    // The format is that of the page's maps, so that texels are filtered in the same way.
    colorFormat: gl.SRGB8_ALPHA8,
  });
  const picture = xr.getBaseLayer() as XRLayer;
  session.updateRenderState({ layers: [layer, picture] });
  const copy = createCopy(gl, faceSize);
  let copiedMap: { readonly cube: Cube; readonly ring: number | null } | null = null;
  let lastYaw: number | null = null;

  /** Copies a map into the layer; returns false if it is already there. */
  function copyMap(cube: Cube): boolean {
    if (copiedMap?.cube === cube && copiedMap.ring === cube.ringShown && !layer.needsRedraw) return false;
    copy(colorOf(renderer, cube), binding.getSubImage(layer, xr.getFrame()).colorTexture);
    copiedMap = { cube, ring: cube.ringShown };
    return true;
  }

  /** Rotates the layer against the headset's space, so that it stays in the world; returns false if it already does. */
  function rotateLayer(yaw: number): boolean {
    if (lastYaw === yaw) return false;
    lastYaw = yaw;
    layer.orientation = new DOMPointReadOnly(0, Math.sin(-yaw / 2), 0, Math.cos(yaw / 2));
    return true;
  }

  return {
    show(cube, yaw) {
      // The texels of a coarse map do not fit the layer.
      if (cube.size !== faceSize) return false;
      const changes = [copyMap(cube), rotateLayer(yaw), !session.renderState.layers?.includes(layer)];
      // A change may be visible only in the next frame.
      return !changes.includes(true);
    },
  };
}

/** Creates a function that copies all faces of a cube map, texel by texel, and leaves the state of WebGL as it was. */
function createCopy(gl: WebGL2RenderingContext, size: number): (from: WebGLTexture, to: WebGLTexture) => void {
  const [source, target] = [gl.createFramebuffer(), gl.createFramebuffer()];
  const attach = (buffer: number, face: number, texture: WebGLTexture): void =>
    gl.framebufferTexture2D(buffer, gl.COLOR_ATTACHMENT0, gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, texture, 0);
  return (from, to) => {
    const before = [gl.READ_FRAMEBUFFER_BINDING, gl.DRAW_FRAMEBUFFER_BINDING].map((name) => gl.getParameter(name));
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, source);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, target);
    for (let face = 0; face < FACES; face++) {
      attach(gl.READ_FRAMEBUFFER, face, from);
      attach(gl.DRAW_FRAMEBUFFER, face, to);
      gl.blitFramebuffer(0, 0, size, size, 0, 0, size, size, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    }
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, before[0]);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, before[1]);
  };
}
