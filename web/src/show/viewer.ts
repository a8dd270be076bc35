/** The picture on the screen: which region is loaded, what of it is shown, and one frame after the other. */
import { Group, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import type { Manifest, Point } from '../bundle/manifest';
import type { Pose } from '../control/pose';
import { createCube } from './cubes';
import { startDecoder, type Worked } from './decoder';
import { type Fetch, loadRegion, type Loading } from './loader';
import { createShared } from './materials';
import { createPainter, type Picture } from './picture';
import { createRegion, type Region, trianglesShown } from './region';
import { createStage, type Manner, type Shown, type Stage } from './stage';
import { createUploads } from './uploads';

/** Milliseconds of a frame that uploads may take: docs/view.md. */
export const UPLOAD_BUDGET = 3;
/** Metres at which the picture begins and ends. */
const NEAR = 0.05;
const FAR = 30_000;

export interface Settings extends Manner {
  readonly manifest: Manifest;
  readonly fetch: Fetch;
  /** Number of the last ring that is loaded. */
  readonly last: number;
  readonly worker: URL;
  /** Vertical field of view, degrees. */
  readonly angle: number;
  readonly antialias: boolean;
  readonly failed: (reason: Error) => void;
}

export interface Viewer {
  readonly renderer: WebGLRenderer;
  readonly camera: PerspectiveCamera;
  /** Moves the headset's space: its position is the user's floor. */
  readonly rig: Group;
  /** Show a region from its ring 0 on; the one before is let go. */
  open(number: number): void;
  /** Draw a frame for a user, some seconds after the one before. */
  frame(pose: Pose | null, seconds: number): void;
  /** Draw one state, whatever the time: for tests and screenshots. */
  still(picture: Omit<Picture, 'region'>, pose: Pose): void;
  /** Part of the width, from the left, in which the picture is the conventional one; null for none. */
  setDivider(share: number | null): void;
  /** The picture that was drawn last, as PNG. */
  photo(): Promise<Blob>;
  readonly facts: Facts;
  dispose(): void;
}

/** What the panel shows of the picture. */
export interface Facts {
  readonly region: number;
  readonly shown: Shown | null;
  readonly arrived: number;
  readonly triangles: number;
  /** Milliseconds that uploads took in the last frame. */
  readonly upload: number;
}

interface Open {
  readonly number: number;
  readonly region: Region;
  readonly stage: Stage;
  readonly stop: AbortController;
  arrived: number;
  shown: Shown | null;
}

export function createViewer(canvas: HTMLCanvasElement, settings: Settings): Viewer {
  const { manifest } = settings;
  const faceSize = manifest.map.face_size;
  const nearShare = manifest.morph.near_share;
  const renderer = new WebGLRenderer({ canvas, antialias: settings.antialias, powerPreference: 'high-performance' });
  renderer.autoClear = false;
  renderer.sortObjects = false;
  renderer.debug.checkShaderErrors = true;
  const camera = new PerspectiveCamera(settings.angle, 1, NEAR, FAR);
  camera.rotation.order = 'YXZ';
  const rig = new Group();
  rig.add(camera);
  // A map of one texel, until the first one is there: shaders refuse textures of another kind than they ask for.
  const blank = createCube(renderer, 1);
  const shared = createShared(blank.color, blank.codes);
  const uploads = createUploads();
  const workers: Worked[] = [startDecoder(settings.worker), startDecoder(settings.worker)];
  const feet = { x: 0, y: 0, z: 0 };

  /** Put the user's place relative to a centre into the rig, so that the GPU sees small numbers only. */
  function place(center: Point): void {
    rig.position.set(feet.x - center[0], feet.y - center[1], feet.z - center[2]);
    rig.updateMatrixWorld(true);
  }

  const painter = createPainter(renderer, shared, nearShare, faceSize, place);
  const warming = new Scene();
  const loading: Loading = {
    manifest,
    renderer,
    shared,
    uploads,
    geometry: (workers[0] as Worked).decode,
    maps: (workers[1] as Worked).decode,
    fetch: settings.fetch,
    last: settings.last,
    sent: new Set(),
    warm(mesh) {
      // Rendering nothing of it uploads it.
      const { count } = mesh.geometry.drawRange;
      mesh.geometry.setDrawRange(0, 0);
      warming.children = [mesh];
      renderer.render(warming, camera);
      warming.children = [];
      mesh.geometry.setDrawRange(0, count);
    },
  };
  let open: Open | null = null;
  let upload = 0;
  let divider: number | null = null;

  function close(): void {
    open?.stop.abort();
    open?.region.dispose();
    open = null;
  }

  function setPose({ position: [x, y, z], yaw, pitch }: Pose): void {
    Object.assign(feet, { x, y, z });
    camera.position.set(0, 0, 0);
    camera.rotation.set(pitch, yaw, 0);
  }

  function fit(): void {
    if (renderer.xr.isPresenting) return;
    const { clientWidth: width, clientHeight: height } = canvas;
    const ratio = Math.min(window.devicePixelRatio, 2);
    if (canvas.width === Math.floor(width * ratio) && canvas.height === Math.floor(height * ratio)) return;
    renderer.setPixelRatio(ratio);
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  }

  /** Draw what is shown of a region, morphed or conventional. */
  function paint({ region }: Open, shown: Shown, isMorphed: boolean): void {
    const { radius, strength } = shown.grown;
    const picture = { region, radius, strength: isMorphed ? strength : null };
    painter.draw({ ...picture, ring: shown.ring }, camera, 1);
    if (shown.fading && shown.fading.share > 0) {
      painter.draw({ ...picture, ring: shown.fading.ring }, camera, shown.fading.share);
    }
  }

  function paintBoth(of: Open, shown: Shown): void {
    if (divider === null || renderer.xr.isPresenting) {
      paint(of, shown, true);
      return;
    }
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const left = Math.round(divider * width);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, left, height);
    paint(of, shown, false);
    renderer.setScissor(left, 0, width - left, height);
    paint(of, shown, true);
    renderer.setScissorTest(false);
  }

  return {
    renderer,
    camera,
    rig,
    open(number) {
      const entry = manifest.regions[number];
      if (!entry) throw new Error(`there is no region ${number}`);
      close();
      const radii = entry.rings.slice(1).map((ring) => ring.radius);
      const stage = createStage({ ...manifest.growth, radii, nearShare }, settings);
      const stop = new AbortController();
      const region = createRegion(renderer, entry, faceSize);
      const opened: Open = { number, region, stage, stop, arrived: -1, shown: null };
      open = opened;
      const arrived = (ring: number): void => {
        opened.arrived = ring;
        stage.arrive(ring);
      };
      loadRegion(loading, region, arrived, (ring) => stage.replaceable(ring), stop.signal).catch((reason: unknown) => {
        if (!stop.signal.aborted) settings.failed(reason instanceof Error ? reason : new Error(String(reason)));
      });
    },
    frame(pose, seconds) {
      if (pose) setPose(pose);
      fit();
      upload = uploads.run(UPLOAD_BUDGET);
      if (!open) return;
      open.shown = open.stage.advance(seconds);
      if (open.shown) paintBoth(open, open.shown);
    },
    still(picture, pose) {
      if (!open) throw new Error('no region is open');
      setPose(pose);
      painter.draw({ ...picture, region: open.region }, camera, 1);
    },
    setDivider(share) {
      divider = share;
    },
    photo() {
      // In the same task as the drawing: a canvas keeps its picture no longer.
      if (open?.shown) paintBoth(open, open.shown);
      return new Promise((done, failed) => {
        canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error('The browser gives no picture'))), 'image/png');
      });
    },
    get facts() {
      const ring = open?.shown?.fading?.ring ?? open?.shown?.ring ?? 0;
      return {
        region: open?.number ?? 0,
        shown: open?.shown ?? null,
        arrived: open?.arrived ?? -1,
        triangles: open ? trianglesShown(open.region, ring) : 0,
        upload,
      };
    },
    dispose() {
      close();
      for (const worker of workers) worker.dispose();
      blank.dispose();
      renderer.dispose();
    },
  };
}
