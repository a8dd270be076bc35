/** Emulates a headset for tests. This script runs before that of the page, and is not part of the page. */
import { metaQuest2, metaQuest3, XRDevice } from 'iwer';
import type { Facts } from '../../src/show/viewer';
import { installLayers, type LayersFound } from './layers';

/** Settings of a test. */
interface EmulatorSettings {
  readonly headset: 'quest2' | 'quest3';
  /** For each eye, the tangents of the angles to the sides of its picture. */
  readonly eyes: Readonly<Record<'left' | 'right', Tangents>>;
  /** Distance of the eyes, metres. */
  readonly ipd: number;
  /** Whether the browser supports WebXR Layers. */
  readonly layers: boolean;
}

interface Tangents {
  readonly left: number;
  readonly right: number;
  readonly down: number;
  readonly up: number;
}

/** Picture of a frame, with both eyes side by side: RGBA in base64, rows from the bottom. */
interface Capture {
  readonly width: number;
  readonly height: number;
  readonly pixels: string;
  readonly shown: Facts['shown'];
  /** Positions of the eyes that the page passed to the shaders of near geometry. */
  readonly eyes: readonly (readonly number[])[];
}

declare global {
  interface Window {
    wanted: EmulatorSettings;
    emulated: {
      readonly device: XRDevice;
      readonly layers: LayersFound | null;
      /** Returns the first frame for whose picture `isWanted` returns true. */
      capture(isWanted: (shown: NonNullable<Facts['shown']>) => boolean): Promise<Capture>;
      /** Waits until some frames are drawn. */
      frames(count: number): Promise<void>;
      /** Waits until the user's floor has not moved for as many frames as a jump takes. */
      rest(): Promise<void>;
    };
  }
}

const { headset, eyes, ipd, layers } = window.wanted;
const device = new XRDevice(headset === 'quest2' ? metaQuest2 : metaQuest3, { ipd, stereoEnabled: true });
device.installRuntime({ forceInstall: true });
const found = layers ? installLayers(() => window.nearfar?.viewer.renderer.resetState()) : null;

/** The picture of each eye extends farther outwards than inwards, unlike that of the emulator. */
Object.defineProperty(XRView.prototype, 'projectionMatrix', {
  get(this: XRView): Float32Array {
    const { left, right, down, up } = eyes[this.eye === 'right' ? 'right' : 'left'];
    const [near, far] = [0.05, 30_000];
    const [scaleX, scaleY] = [2 / (right - left), 2 / (up - down)];
    return new Float32Array([
      scaleX, 0, 0, 0,
      0, scaleY, 0, 0,
      (right + left) / (right - left), (up + down) / (up - down), -(far + near) / (far - near), -1,
      0, 0, (-2 * far * near) / (far - near), 0,
    ]);
  },
});

/** Positions of eyes that the page has set as uniforms since the last frame. */
const eyePositions = new Map<string, readonly number[]>();
const names = new WeakMap<WebGLUniformLocation, string>();
const { getUniformLocation, uniform3f, uniform3fv } = WebGL2RenderingContext.prototype;
WebGL2RenderingContext.prototype.getUniformLocation = function (program, name) {
  const found = getUniformLocation.call(this, program, name);
  if (found) names.set(found, name);
  return found;
};

function recordEye(location: WebGLUniformLocation | null, values: readonly number[]): void {
  if (location && names.get(location) === 'cameraPosition') eyePositions.set(values.join(), values);
}

WebGL2RenderingContext.prototype.uniform3f = function (location, x, y, z) {
  recordEye(location, [x, y, z]);
  uniform3f.call(this, location, x, y, z);
};
WebGL2RenderingContext.prototype.uniform3fv = function (location, data, ...rest) {
  recordEye(location, [...data]);
  uniform3fv.call(this, location, data, ...rest);
};

function findSession(): XRSession {
  const session = window.nearfar?.viewer.renderer.xr.getSession();
  if (!session) throw new Error('the page is not in the headset');
  return session;
}

function encodeBase64(bytes: Uint8Array): string {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

function readPicture(): Capture {
  const { viewer } = window.nearfar as NonNullable<typeof window.nearfar>;
  const gl = viewer.renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const pixels = new Uint8Array(4 * width * height);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return { width, height, pixels: encodeBase64(pixels), shown: viewer.facts.shown, eyes: [...eyePositions.values()] };
}

/** Frames until a timeout; frames without movement after which the user rests; least movement, metres. */
const [MAX_FRAMES, REST_FRAMES, MIN_MOVEMENT] = [2000, 20, 1e-4] as const;

window.emulated = {
  device,
  layers: found,
  capture: (isWanted) =>
    new Promise((done, fail) => {
      let frames = 0;
      const checkFrame = (): void => {
        const shown = window.nearfar?.viewer.facts.shown;
        // The first two frames may have begun before this call.
        if (++frames > 2 && shown && isWanted(shown)) done(readPicture());
        else if (frames > MAX_FRAMES) fail(new Error(`no frame is as wanted: ${JSON.stringify([shown, found])}`));
        else {
          eyePositions.clear();
          findSession().requestAnimationFrame(checkFrame);
        }
      };
      findSession().requestAnimationFrame(checkFrame);
    }),
  frames: (count) =>
    new Promise((done) => {
      let remaining = count;
      const next = (): unknown => (remaining-- > 0 ? findSession().requestAnimationFrame(next) : done());
      next();
    }),
  async rest() {
    const { viewer } = window.nearfar as NonNullable<typeof window.nearfar>;
    let before = viewer.rig.position.clone();
    for (let [restFrames, frames] = [0, 0]; restFrames < REST_FRAMES; frames++) {
      if (frames > MAX_FRAMES) throw new Error('the user does not come to rest');
      await window.emulated.frames(1);
      restFrames = viewer.rig.position.distanceTo(before) < MIN_MOVEMENT ? restFrames + 1 : 0;
      before = viewer.rig.position.clone();
    }
  },
};
