/** The picture on the screen, one frame after the other. */
import { Group, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { BundleError } from '../bundle/error';
import type { Manifest, Point } from '../bundle/manifest';
import type { Bounds } from '../control/limit';
import type { Pose } from '../control/pose';
import type { Vector } from '../control/vector';
import { createAtlas, type Holding } from './atlas';
import { createCube } from './cubes';
import { startDecoder, type Worked } from './decoder';
import { createJourney, type Journey, type Leg } from './journey';
import type { Fetch, Loading } from './loader';
import { watchLoss } from './loss';
import { createShared } from './materials';
import { pick } from './pick';
import { createPainter, type Picture } from './picture';
import { createPrograms } from './programs';
import { cubeOf, trianglesShown } from './region';
import type { Manner, Shown } from './stage';
import { createStore } from './store';
import { createUploads } from './uploads';
import { createVeil } from './veil';
import type { Floor } from '../xr/floor';
import type { MapLayer } from '../xr/layer';
import { resolveOnce } from '../xr/samples';

/** Milliseconds of a frame that uploads may take: docs/view.md. */
export const UPLOAD_BUDGET = 3;
/** Metres at which the picture begins and ends. */
const NEAR = 0.05;
const FAR = 30_000;

export interface Settings extends Manner {
  readonly manifest: Manifest;
  readonly fetch: Fetch;
  readonly worker: URL;
  /** Vertical field of view, degrees. */
  readonly angle: number;
  readonly antialias: boolean;
  readonly failed: (reason: Error) => void;
  /** The user was put to another place, which frames are to be drawn for from now on. */
  readonly moved: (pose: Pose) => void;
  /** The browser took the graphics away, or gave them back. */
  readonly lost: (isLost: boolean) => void;
}

export interface Viewer {
  readonly renderer: WebGLRenderer;
  readonly camera: PerspectiveCamera;
  /** Moves the headset's space: its position is the user's floor. */
  readonly rig: Group;
  /** Texels along an edge of a map. */
  readonly faceSize: number;
  /** Begin in a region, from its ring 0 on; all others are let go. */
  open(number: number): void;
  /** Go to another place by a cross-fade, as soon as its region can be shown. */
  go(target: Pose): void;
  /** The point of near geometry that the picture shows, x and y from its upper left from 0 to 1; null for none. */
  pointAt(x: number, y: number): Vector | null;
  /** Load again what failed. */
  retry(): void;
  /** Draw a frame for a user, some seconds after the one before. In a headset the pose is what it tells. */
  frame(pose: Pose, seconds: number): void;
  /** Put the floor of a headset's user somewhere. */
  stand(floor: Floor): void;
  /** Let a layer of the headset show the map while nothing fades; null to draw it. */
  setMapLayer(layer: MapLayer | null): void;
  /** Darken the picture, from 0 to 1 for black. */
  setVeil(darkness: number): void;
  /** Draw one state, whatever the time: for tests and screenshots. */
  still(picture: Omit<Picture, 'region'>, pose: Pose): void;
  /** Part of the width, from the left, in which the picture is the conventional one; null for none. */
  setDivider(share: number | null): void;
  /** The picture that was drawn last, as PNG. */
  photo(): Promise<Blob>;
  readonly facts: Facts;
  dispose(): void;
}

/** The panel's facts of the picture. */
export interface Facts extends Holding {
  readonly region: number;
  /** Region of the place that the user is about to go to; null for none. */
  readonly goal: number | null;
  readonly shown: Shown | null;
  readonly arrived: number;
  /** Bytes of the region's files that are here, and of all of them. */
  readonly received: number;
  readonly expected: number;
  readonly triangles: number;
  /** Milliseconds that uploads took in the last frame. */
  readonly upload: number;
  /** Where the user may be. */
  readonly bounds: Bounds | null;
  /** The region whose picture goes out; null for none. */
  readonly leaving: number | null;
  /** Meshes whose arrays others use, too. */
  readonly shared: number;
}

export function createViewer(canvas: HTMLCanvasElement, settings: Settings): Viewer {
  const { manifest } = settings;
  const faceSize = manifest.map.face_size;
  const nearShare = manifest.morph.near_share;
  const renderer = createRenderer(canvas, settings.antialias);
  const camera = new PerspectiveCamera(settings.angle, 1, NEAR, FAR);
  camera.rotation.order = 'YXZ';
  const rig = new Group();
  rig.add(camera);
  const veil = createVeil();
  // Drawn over the picture: what a headset adds to the rig, and the veil.
  const overlay = new Scene();
  overlay.add(rig, veil.mesh);
  // A map of one texel, until the first one is there: shaders refuse textures of another kind than they ask for.
  let blank = createCube(renderer, 1);
  const shared = createShared(blank.color, blank.codes);
  const uploads = createUploads();
  const workers: Worked[] = [startDecoder(settings.worker), startDecoder(settings.worker)];
  const feet = { x: 0, y: 0, z: 0 };

  /** Put the user's place relative to a centre into the rig, so that the GPU sees small numbers only. */
  function place(center: Point): void {
    rig.position.set(feet.x - center[0], feet.y - center[1], feet.z - center[2]);
    rig.updateMatrixWorld(true);
  }

  const painter = createPainter(renderer, shared, nearShare, faceSize, () => blank, place);
  painter.prepare(camera);
  const programs = createPrograms(renderer, camera, shared);
  const warming = new Scene();
  const store = createStore();
  const loading: Loading = {
    manifest,
    renderer,
    shared,
    store,
    uploads,
    geometry: (workers[0] as Worked).decode,
    maps: (workers[1] as Worked).decode,
    fetch: settings.fetch,
    programs,
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
  const atlas = createAtlas({
    loading,
    manner: settings,
    failed(region, reason) {
      journey?.failed(region);
      settings.failed(reason);
    },
  });
  let journey: Journey | null = null;
  let leg: Leg | null = null;
  let user: Pose | null = null;
  let upload = 0;
  let divider: number | null = null;
  let mapLayer: MapLayer | null = null;

  let wasIn: number | null = null;
  const loss = watchLoss(
    canvas,
    () => {
      wasIn = journey?.region ?? null;
      close();
      blank.dispose();
      programs.forget();
      settings.lost(true);
    },
    () => {
      renderer.setClearAlpha(0);
      blank = createCube(renderer, 1);
      [shared.map.value, shared.codes.value] = [blank.color, blank.codes];
      painter.prepare(camera);
      if (wasIn !== null) begin(wasIn);
      settings.lost(false);
    },
  );

  function close(): void {
    for (const region of atlas.holding.regions) atlas.close(region);
    journey = leg = null;
  }

  /** Begin in a region, with nothing loaded. */
  function begin(number: number): void {
    close();
    const moved = (pose: Pose): void => {
      user = pose;
      settings.moved(pose);
    };
    const { regions, growth } = manifest;
    journey = createJourney({ regions, marginShare: marginShare(manifest), fade: growth.fade, moved }, atlas, number);
  }

  function setPose({ position: [x, y, z], yaw, pitch }: Pose): void {
    stand({ position: [x, y, z], yaw: 0 });
    camera.position.set(0, 0, 0);
    camera.rotation.set(pitch, yaw, 0);
  }

  function stand({ position: [x, y, z], yaw }: Floor): void {
    Object.assign(feet, { x, y, z });
    rig.rotation.y = yaw;
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

  /** Draw what is shown of a region, morphed or conventional, as a share over what is there. */
  function paint(number: number, opacity: number, isMorphed: boolean, withMap = true): void {
    const open = atlas.find(number);
    if (!open?.shown || opacity === 0) return;
    const { ring, grown, fading } = open.shown;
    const picture = { region: open.region, radius: grown.radius, strength: isMorphed ? grown.strength : null };
    painter.draw({ ...picture, ring }, camera, opacity, withMap);
    // While a region fades in, nothing in it does.
    if (opacity === 1 && fading && fading.share > 0) {
      painter.draw({ ...picture, ring: fading.ring }, camera, fading.share);
    }
  }

  /** Draw the picture of a region over the one that it takes over from. */
  function paintLeg({ region, leaving }: Leg, isMorphed: boolean): void {
    const before = leaving?.pose ?? user;
    if (leaving && before) {
      setPose(before);
      paint(leaving.region, 1, isMorphed);
    }
    if (user) setPose(user);
    paint(region, leaving?.share ?? 1, isMorphed);
  }

  /** The same for both eyes of a headset, which has its own pose: a place that was left is not shown from elsewhere. */
  function paintEyes({ region, leaving }: Leg): void {
    if (leaving && !leaving.pose) paint(leaving.region, 1, true);
    paint(region, leaving?.share ?? 1, true, leaving !== null || !isApart(region));
  }

  /** Whether a layer of the headset shows the map of a region in this frame. */
  function isApart(number: number): boolean {
    const open = atlas.find(number);
    if (!open?.shown || open.shown.fading) return false;
    return mapLayer?.show(cubeOf(open.region, open.shown.ring), rig.rotation.y) ?? false;
  }

  function paintAll(): void {
    if (!leg || !atlas.find(leg.region)?.shown) return;
    if (renderer.xr.isPresenting) {
      paintEyes(leg);
      return;
    }
    if (divider === null) {
      paintLeg(leg, true);
      return;
    }
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const left = Math.round(divider * width);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, left, height);
    paintLeg(leg, false);
    renderer.setScissor(left, 0, width - left, height);
    paintLeg(leg, true);
    renderer.setScissorTest(false);
  }

  function advance(pose: Pose, seconds: number): void {
    // Before the first picture nothing can jerk.
    upload = uploads.run(leg && atlas.find(leg.region)?.shown ? UPLOAD_BUDGET : Number.POSITIVE_INFINITY);
    if (!journey) return;
    leg = journey.advance(seconds, pose);
    // Nothing else changes while a region fades in.
    atlas.advance(leg.region, leg.leaving ? 0 : seconds, journey.least);
    paintAll();
  }

  return {
    renderer,
    camera,
    rig,
    faceSize,
    open: begin,
    go: (target) => journey?.go(target),
    pointAt(x, y) {
      const open = leg && atlas.find(leg.region);
      if (!open?.shown || !user) return null;
      const { region, shown } = open;
      setPose(user);
      const { radius, strength } = shown.grown;
      const found = pick(renderer, camera, [x, y], () => {
        painter.draw({ region, ring: shown.ring, radius, strength }, camera, 1, false);
      });
      const { center } = region.entry;
      return found && [found.x + center[0], found.y + center[1], found.z + center[2]];
    },
    retry: atlas.retry,
    frame(pose, seconds) {
      user = pose;
      if (loss.isLost) return;
      fit();
      const { isPresenting } = renderer.xr;
      if (isPresenting) resolveOnce(renderer, () => advance(pose, seconds));
      else advance(pose, seconds);
      if (isPresenting || veil.mesh.visible) renderer.render(overlay, camera);
    },
    stand,
    setMapLayer(layer) {
      mapLayer = layer;
    },
    setVeil: veil.set,
    still(picture, pose) {
      const open = journey && atlas.find(journey.region);
      if (!open) throw new Error('no region is open');
      setPose(pose);
      painter.draw({ ...picture, region: open.region }, camera, 1);
    },
    setDivider(share) {
      divider = share;
    },
    photo() {
      if (renderer.xr.isPresenting) return Promise.reject(new Error('Pictures are saved outside the headset'));
      if (loss.isLost || !leg || !atlas.find(leg.region)?.shown) {
        return Promise.reject(new Error('There is no picture yet'));
      }
      // In the same task as the drawing: a canvas keeps its picture no longer.
      paintAll();
      return new Promise((done, failed) => {
        canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error('The browser gives no picture'))), 'image/png');
      });
    },
    get facts() {
      const region = journey?.region ?? 0;
      const open = atlas.find(region);
      const ring = open?.shown?.fading?.ring ?? open?.shown?.ring ?? 0;
      return {
        region,
        goal: journey?.goal ?? null,
        leaving: leg?.leaving?.region ?? null,
        shown: open?.shown ?? null,
        arrived: open?.arrived ?? -1,
        received: open?.received ?? 0,
        expected: open?.expected ?? 0,
        triangles: open ? trianglesShown(open.region, ring) : 0,
        upload,
        bounds: journey?.bounds ?? null,
        ...atlas.holding,
        shared: store.shared,
      };
    },
    dispose() {
      atlas.dispose();
      for (const worker of workers) worker.dispose();
      blank.dispose();
      loss.dispose();
      renderer.dispose();
      // Browsers keep few contexts at a time; this one is not left to the collector.
      renderer.forceContextLoss();
    },
  };
}

function createRenderer(canvas: HTMLCanvasElement, antialias: boolean): WebGLRenderer {
  let renderer: WebGLRenderer;
  try {
    renderer = new WebGLRenderer({ canvas, antialias, powerPreference: 'high-performance' });
  } catch (error) {
    throw new BundleError(error instanceof Error ? error.message : String(error), 'webgl');
  }
  renderer.autoClear = false;
  // A layer of a headset lies below.
  renderer.setClearAlpha(0);
  renderer.sortObjects = false;
  renderer.debug.checkShaderErrors = true;
  return renderer;
}

/** The fold margin as a share of the morph's radius: of the cylinder it is its near part, at any radius. */
function marginShare({ morph, regions }: Manifest): number {
  const [first] = regions;
  if (!first || !Number.isFinite(first.cut)) return morph.near_share;
  return Math.max(first.fold_margin / first.cut, Number.EPSILON);
}
