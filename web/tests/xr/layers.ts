/**
 * Emulates WebXR Layers for tests: creates projection and cube layers, and draws those of a session, in order, onto the
 * canvas. Real devices may behave differently.
 */

interface Layer {
  readonly kind: 'projection' | 'cube';
  readonly texture: WebGLTexture;
  readonly depth: WebGLTexture | null;
  readonly textureWidth: number;
  readonly textureHeight: number;
  readonly ignoreDepthValues: boolean;
  orientation: DOMPointReadOnly;
  needsRedraw: boolean;
  fixedFoveation: number;
}

export interface LayersFound {
  /** Number of times that the page has written a cube layer. */
  writes: number;
  /** Number of times that multisample buffers were resolved and invalidated. */
  resolves: number;
  /** Number of draws after that in the same frame, which are lost. */
  lost: number;
  /** Share of the projection layer through which the layers below were visible in the last frame. */
  clear: number;
  readonly cube: Layer | null;
}

const VERTEX = `#version 300 es
out vec2 at;
void main() {
  at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(at, 0.0, 1.0);
}`;

const CUBE = `#version 300 es
precision highp float;
precision highp samplerCube;
uniform samplerCube image;
uniform mat4 to_space;
uniform vec4 turn;
in vec2 at;
out vec4 shade;
void main() {
  vec4 place = to_space * vec4(at, 1.0, 1.0);
  vec3 d = place.xyz / place.w - (to_space * vec4(0.0, 0.0, -1.0, 0.0)).xyz / (to_space * vec4(0.0, 0.0, -1.0, 0.0)).w;
  // Inverse of the layer's rotation.
  vec3 axis = -turn.xyz;
  d += 2.0 * cross(axis, cross(axis, d) + turn.w * d);
  vec3 c = texture(image, d).rgb;
  shade = vec4(mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308)))), 1.0);
}`;

const PLANE = `#version 300 es
precision highp float;
uniform sampler2D image;
in vec2 at;
out vec4 shade;
void main() {
  shade = texelFetch(image, ivec2(gl_FragCoord.xy), 0);
}`;

/** Adds WebXR Layers to the browser. Projection layers have the size of the window; `reset` resets three.js's state. */
export function installLayers(reset: () => void): LayersFound {
  const found = { writes: 0, resolves: 0, lost: 0, clear: 0, cube: null as Layer | null };
  let layers: Layer[] = [];
  let pending: Layer[] | null = null;
  let context: WebGL2RenderingContext | null = null;
  let programs: Record<Layer['kind'], WebGLProgram> | null = null;
  let isInvalidated = false;

  class Binding {
    constructor(_session: XRSession, gl: WebGL2RenderingContext) {
      context = gl;
    }

    createProjectionLayer(): Layer {
      const gl = context as WebGL2RenderingContext;
      const [width, height] = [window.innerWidth, window.innerHeight];
      const createTexture = (format: number): WebGLTexture => {
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        return texture;
      };
      const [color, depth] = [createTexture(gl.RGBA8), createTexture(gl.DEPTH_COMPONENT24)];
      const projection = createLayer('projection', color, depth, width, height);
      reset();
      return projection;
    }

    createCubeLayer({ viewPixelWidth: size, colorFormat }: { viewPixelWidth: number; colorFormat: number }): Layer {
      const gl = context as WebGL2RenderingContext;
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
      gl.texStorage2D(gl.TEXTURE_CUBE_MAP, 1, colorFormat, size, size);
      gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
      found.cube = createLayer('cube', texture, null, size, size);
      reset();
      return found.cube;
    }

    getViewSubImage({ texture, depth, textureWidth, textureHeight }: Layer, view: XRView): object {
      const width = textureWidth / 2;
      const viewport = { x: view.eye === 'right' ? width : 0, y: 0, width, height: textureHeight };
      return { colorTexture: texture, depthStencilTexture: depth, viewport };
    }

    getSubImage(cube: Layer, frame: XRFrame): object {
      if (!frame) throw new Error('there is no frame');
      found.writes += 1;
      cube.needsRedraw = false;
      return { colorTexture: cube.texture };
    }
  }

  function createLayer(
    kind: Layer['kind'],
    texture: WebGLTexture,
    depth: WebGLTexture | null,
    textureWidth: number,
    textureHeight: number,
  ): Layer {
    const orientation = new DOMPointReadOnly();
    const state = { ignoreDepthValues: true, orientation, needsRedraw: true, fixedFoveation: 0 };
    return { kind, texture, depth, textureWidth, textureHeight, ...state };
  }

  /** Begins a frame: clears projection layers; cube layers keep their content. */
  function beginFrame(gl: WebGL2RenderingContext): void {
    if (pending) layers = pending;
    pending = null;
    isInvalidated = false;
    const buffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
    for (const { kind, texture } of layers) {
      if (kind !== 'projection') continue;
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    }
    gl.deleteFramebuffer(buffer);
    reset();
  }

  /** Draws all layers onto the canvas. */
  function drawLayers(gl: WebGL2RenderingContext, frame: XRFrame, space: XRReferenceSpace): void {
    programs ??= { cube: programOf(gl, CUBE), projection: programOf(gl, PLANE) };
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.SCISSOR_TEST);
    gl.enable(gl.BLEND);
    gl.blendEquation(gl.FUNC_ADD);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.colorMask(true, true, true, true);
    gl.bindVertexArray(null);
    gl.activeTexture(gl.TEXTURE0);
    gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
    for (const { kind, texture, orientation: q } of layers) {
      const program = programs[kind];
      gl.useProgram(program);
      gl.bindTexture(kind === 'cube' ? gl.TEXTURE_CUBE_MAP : gl.TEXTURE_2D, texture);
      if (kind === 'projection') gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      for (const view of frame.getViewerPose(space)?.views ?? []) {
        const width = gl.drawingBufferWidth / 2;
        gl.viewport(view.eye === 'right' ? width : 0, 0, width, gl.drawingBufferHeight);
        if (kind === 'cube') {
          const { matrix } = view.transform;
          const inverse = new DOMMatrix([...matrix]).multiply(new DOMMatrix([...view.projectionMatrix]).inverse());
          gl.uniformMatrix4fv(gl.getUniformLocation(program, 'to_space'), false, inverse.toFloat32Array());
          gl.uniform4f(gl.getUniformLocation(program, 'turn'), q.x, q.y, q.z, q.w);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
      }
    }
    found.clear = clearShare(gl);
    reset();
  }

  /** Returns the share of the projection layer that is transparent. */
  function clearShare(gl: WebGL2RenderingContext): number {
    const projection = layers.find(({ kind }) => kind === 'projection');
    if (!projection) return 0;
    const buffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, projection.texture, 0);
    const { textureWidth, textureHeight } = projection;
    const pixels = new Uint8Array(4 * textureWidth * textureHeight);
    gl.readPixels(0, 0, textureWidth, textureHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(buffer);
    return pixels.filter((value, index) => index % 4 === 3 && value === 0).length / (pixels.length / 4);
  }

  /** Counts how often buffers are invalidated, and draws after that. */
  function watchDraws(): void {
    const prototype = WebGL2RenderingContext.prototype;
    const { invalidateFramebuffer, drawElements, drawArrays } = prototype;
    prototype.invalidateFramebuffer = function (...call) {
      isInvalidated = true;
      found.resolves += 1;
      invalidateFramebuffer.apply(this, call);
    };
    prototype.drawElements = function (...call) {
      if (isInvalidated) found.lost += 1;
      drawElements.apply(this, call);
    };
    prototype.drawArrays = function (...call) {
      if (isInvalidated && this.getParameter(this.FRAMEBUFFER_BINDING) !== null) found.lost += 1;
      drawArrays.apply(this, call);
    };
  }

  const session = XRSession.prototype;
  const { requestAnimationFrame, updateRenderState } = session;
  const getter = Object.getOwnPropertyDescriptor(session, 'renderState')?.get;
  Object.defineProperty(session, 'renderState', {
    get(this: XRSession) {
      return Object.assign(Object.create(getter?.call(this) as object), { layers });
    },
  });
  session.updateRenderState = function (state: XRRenderStateInit = {}) {
    const { layers: newLayers, ...rest } = state;
    if (!newLayers) return updateRenderState.call(this, rest);
    pending = newLayers as unknown as Layer[];
    // The emulator draws frames only for a session with a base layer.
    const baseLayer = new XRWebGLLayer(this, context as WebGL2RenderingContext);
    return updateRenderState.call(this, { ...rest, baseLayer });
  };
  const spaces = new WeakMap<XRSession, XRReferenceSpace>();
  session.requestAnimationFrame = function (callback) {
    return requestAnimationFrame.call(this, (time, frame) => {
      const gl = context as WebGL2RenderingContext;
      beginFrame(gl);
      callback(time, frame);
      const space = spaces.get(this);
      if (space) drawLayers(gl, frame, space);
    });
  };
  const { requestReferenceSpace } = session;
  session.requestReferenceSpace = async function (this: XRSession, kind: XRReferenceSpaceType) {
    const space = (await requestReferenceSpace.call(this, kind)) as XRReferenceSpace;
    if (kind === 'local-floor') spaces.set(this, space);
    return space;
  } as typeof requestReferenceSpace;
  const features = Object.getOwnPropertyDescriptor(session, 'enabledFeatures')?.get;
  Object.defineProperty(session, 'enabledFeatures', {
    get(this: XRSession) {
      return [...(features?.call(this) as string[]), 'layers'];
    },
  });
  watchDraws();
  Object.assign(window, { XRWebGLBinding: Binding });
  return found;
}

function programOf(gl: WebGL2RenderingContext, fragment: string): WebGLProgram {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind) as WebGLShader;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? '');
  return program;
}
