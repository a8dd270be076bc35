/** An emulated headset, installed in the page before its own script runs. It is no part of the page. */
import { metaQuest2, metaQuest3, XRDevice } from 'iwer';
import type { Facts } from '../../src/show/viewer';
import { installLayers, type LayersFound } from './layers';

/** Settings of a test: a headset, and the tangents of the angles to the sides of each eye's picture. */
interface Wanted {
  readonly headset: 'quest2' | 'quest3';
  readonly eyes: Readonly<Record<'left' | 'right', Tangents>>;
  readonly ipd: number;
  /** Whether the browser has WebXR Layers. */
  readonly layers: boolean;
}

interface Tangents {
  readonly left: number;
  readonly right: number;
  readonly down: number;
  readonly up: number;
}

/** Both eyes of a frame: rows from the bottom, RGBA in base64, side by side. */
interface Captured {
  readonly width: number;
  readonly height: number;
  readonly pixels: string;
  readonly shown: Facts['shown'];
  /** Eye positions that the shaders of near geometry received while the frame was drawn. */
  readonly eyes: readonly (readonly number[])[];
}

declare global {
  interface Window {
    wanted: Wanted;
    emulated: {
      readonly device: XRDevice;
      readonly layers: LayersFound | null;
      capture(isWanted: (shown: NonNullable<Facts['shown']>) => boolean): Promise<Captured>;
      /** Wait until some frames are drawn. */
      frames(count: number): Promise<void>;
      /** Wait until the user's floor has not moved for the frames that a jump takes. */
      rest(): Promise<void>;
    };
  }
}

const { headset, eyes, ipd, layers } = window.wanted;
const device = new XRDevice(headset === 'quest2' ? metaQuest2 : metaQuest3, { ipd, stereoEnabled: true });
device.installRuntime({ forceInstall: true });
const found = layers ? installLayers(() => window.nearfar?.viewer.renderer.resetState()) : null;

/** Headset pictures extend farther outwards than inwards; the emulator's own do not. */
Object.defineProperty(XRView.prototype, 'projectionMatrix', {
  get(this: XRView): Float32Array {
    const { left, right, down, up } = eyes[this.eye === 'right' ? 'right' : 'left'];
    const [near, far] = [0.05, 30_000];
    const [across, along] = [2 / (right - left), 2 / (up - down)];
    return new Float32Array([
      across, 0, 0, 0,
      0, along, 0, 0,
      (right + left) / (right - left), (up + down) / (up - down), -(far + near) / (far - near), -1,
      0, 0, (-2 * far * near) / (far - near), 0,
    ]);
  },
});

/** Uniform values that describe the eyes. */
const told = new Map<string, readonly number[]>();
const names = new WeakMap<WebGLUniformLocation, string>();
const { getUniformLocation, uniform3f, uniform3fv } = WebGL2RenderingContext.prototype;
WebGL2RenderingContext.prototype.getUniformLocation = function (program, name) {
  const found = getUniformLocation.call(this, program, name);
  if (found) names.set(found, name);
  return found;
};

function note(location: WebGLUniformLocation | null, values: readonly number[]): void {
  if (location && names.get(location) === 'cameraPosition') told.set(values.join(), values);
}

WebGL2RenderingContext.prototype.uniform3f = function (location, x, y, z) {
  note(location, [x, y, z]);
  uniform3f.call(this, location, x, y, z);
};
WebGL2RenderingContext.prototype.uniform3fv = function (location, data, ...rest) {
  note(location, [...data]);
  uniform3fv.call(this, location, data, ...rest);
};

function session(): XRSession {
  const found = window.nearfar?.viewer.renderer.xr.getSession();
  if (!found) throw new Error('the page is in no headset');
  return found;
}

function base64(bytes: Uint8Array): string {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

function read(): Captured {
  const { viewer } = window.nearfar as NonNullable<typeof window.nearfar>;
  const gl = viewer.renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const pixels = new Uint8Array(4 * width * height);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return { width, height, pixels: base64(pixels), shown: viewer.facts.shown, eyes: [...told.values()] };
}

/** Frames until a timeout; frames after which a floor counts as resting; and the least movement, metres. */
const [MAX, RESTING, STILL] = [2000, 20, 1e-4] as const;

window.emulated = {
  device,
  layers: found,
  capture: (isWanted) =>
    new Promise((done, failed) => {
      let frames = 0;
      const look = (): void => {
        const shown = window.nearfar?.viewer.facts.shown;
        // The first of the frames may have begun before.
        if (++frames > 2 && shown && isWanted(shown)) done(read());
        else if (frames > MAX) failed(new Error(`no frame is wanted: ${JSON.stringify([shown, found])}`));
        else {
          told.clear();
          session().requestAnimationFrame(look);
        }
      };
      session().requestAnimationFrame(look);
    }),
  frames: (count) =>
    new Promise((done) => {
      let left = count;
      const next = (): unknown => (left-- > 0 ? session().requestAnimationFrame(next) : done());
      next();
    }),
  async rest() {
    const { viewer } = window.nearfar as NonNullable<typeof window.nearfar>;
    let before = viewer.rig.position.clone();
    for (let [resting, all] = [0, 0]; resting < RESTING; all++) {
      if (all > MAX) throw new Error('the user does not come to rest');
      await window.emulated.frames(1);
      resting = viewer.rig.position.distanceTo(before) < STILL ? resting + 1 : 0;
      before = viewer.rig.position.clone();
    }
  },
};
