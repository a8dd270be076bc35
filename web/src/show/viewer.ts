/** The picture on the screen, one frame after the other. */
import { type Group, type PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { BundleError } from '../bundle/error';
import type { RegionEntry } from '../bundle/manifest';
import type { Fetch } from '../bundle/source';
import type { Floor } from '../control/floor';
import type { Bounds } from '../control/limit';
import type { Pose } from '../control/pose';
import { minus, type Vector } from '../control/vector';
import type { Triangles } from '../decode/messages';
import { along } from './along';
import { createAtlas, type Holding } from './atlas';
import { createComposer, type MapLayer } from './composer';
import { createCube } from './cubes';
import { startDecoder, type Worked } from './decoder';
import { createFlight } from './flight';
import { createJourney, type Journey, type Leg } from './journey';
import type { Loading } from './job';
import { watchLoss } from './loss';
import { createShared, type Shared } from './materials';
import { createPicker } from './pick';
import { createPainter, type Guests, type Picture } from './picture';
import { createPrograms } from './programs';
import { trianglesShown } from './region';
import { resolveOnce } from './samples';
import type { Manner, Shown } from './stage';
import { createStore } from './store';
import { createUploads, type Uploads } from './uploads';
import { createVeil } from './veil';
import { createViewpoint } from './viewpoint';
import type { World } from './world';

/** Pictures that tell where near geometry is. */
const NEAR_ALONE = { map: true, guests: true } as const;
/** Milliseconds of a frame that uploads and answers of workers may take: docs/view.md. */
export const UPLOAD_BUDGET = 3;
export interface Settings extends Manner {
  readonly world: World;
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
  /** Steps that wait to be sent to the GPU, for those who measure them. */
  readonly uploads: Uploads;
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
  /** The place at which the picture shows near geometry, x and y from its upper left from 0 to 1; null for none. */
  pointAt(x: number, y: number): Vector | null;
  /** Metres along a ray of the world to near geometry where it is, unmorphed; null for none. */
  along(origin: Vector, direction: Vector): number | null;
  /** Uniforms of the pictures, for materials of guests. */
  readonly shared: Shared;
  /** Draw other users, too; null for none. */
  setGuests(guests: Guests | null): void;
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
  /** Whether the picture is the continuous one at a part of its width. */
  isMorphedAt(x: number): boolean;
  /** The picture that was drawn last, as PNG. */
  photo(): Promise<Blob>;
  readonly facts: Facts;
  dispose(): void;
}

/** The panel's facts of the picture. */
export interface Facts extends Holding {
  readonly region: number;
  /** Its entry; null while nothing is known of it. */
  readonly entry: RegionEntry | null;
  /** Region of the place that the user is about to go to; null for none. */
  readonly goal: number | null;
  readonly shown: Shown | null;
  readonly arrived: number;
  /** Bytes of the region's files that are here, and of all of them. */
  readonly received: number;
  readonly expected: number;
  readonly triangles: Triangles;
  /** Milliseconds that uploads and answers of workers took for the last frame. */
  readonly upload: number;
  /** Where the user may be. */
  readonly bounds: Bounds | null;
  /** The region whose picture goes out; null for none. */
  readonly leaving: number | null;
  /** Meshes whose arrays others use, too. */
  readonly shared: number;
}

export function createViewer(canvas: HTMLCanvasElement, settings: Settings): Viewer {
  const { faceSize, fade, marginShare, nearShare, places } = settings.world;
  const renderer = createRenderer(canvas, settings.antialias);
  const viewpoint = createViewpoint(settings.angle);
  const { camera, rig, setPose, stand } = viewpoint;
  const veil = createVeil();
  // Drawn over the picture: what a headset adds to the rig, and the veil.
  const overlay = new Scene();
  overlay.add(rig, veil.mesh);
  // A map of one texel, until the first one is there: shaders refuse textures of another kind than they ask for.
  let blank = createCube(renderer, 1);
  const shared = createShared(blank.color, blank.codes);
  const flight = createFlight(renderer.getContext() as WebGL2RenderingContext);
  const uploads = createUploads(() => performance.now(), flight);
  const start = (): Worked => startDecoder(settings.worker, uploads.spend);
  const workers: Worked[] = [start(), start()];
  const painter = createPainter(renderer, shared, nearShare, () => blank, viewpoint.place);
  painter.prepare(camera);
  const picker = createPicker(renderer);
  const programs = createPrograms(renderer, camera, shared, uploads);
  const warming = new Scene();
  const store = createStore();
  const loading: Loading = {
    renderer,
    shared,
    store,
    uploads,
    geometry: (workers[0] as Worked).decode,
    maps: (workers[1] as Worked).decode,
    fetch: settings.fetch,
    programs,
    warm(meshes) {
      // Drawing nothing of them makes all that three.js makes when it first draws a mesh.
      for (const { geometry } of meshes) geometry.setDrawRange(0, 0);
      warming.children = [...meshes];
      renderer.render(warming, camera);
      warming.children = [];
      for (const { geometry } of meshes) geometry.setDrawRange(0, Infinity);
    },
  };
  const atlas = createAtlas({
    world: settings.world,
    loading,
    manner: settings,
    failed(region, reason) {
      journey?.failed(region);
      settings.failed(reason);
    },
  });
  const composer = createComposer(renderer, atlas, painter, viewpoint);
  let journey: Journey | null = null;
  let leg: Leg | null = null;
  let user: Pose | null = null;
  let upload = 0;

  let wasIn: number | null = null;
  const loss = watchLoss(
    canvas,
    () => {
      wasIn = journey?.region ?? null;
      close();
      blank.dispose();
      picker.dispose();
      programs.forget();
      uploads.forget();
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
    journey = createJourney({ places, marginShare, fade, moved }, atlas, number);
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

  function advance(pose: Pose, seconds: number): void {
    upload = uploads.run(UPLOAD_BUDGET);
    if (!journey) return;
    leg = journey.advance(seconds, pose);
    // Nothing else changes while a region fades in.
    atlas.advance(leg.region, leg.leaving ? 0 : seconds, journey.least);
    composer.draw(leg, user);
  }

  return {
    uploads,
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
      const { radius } = shown.grown;
      const strength = composer.isMorphedAt(x) ? shown.grown.strength : null;
      const found = picker.pick(camera, [x, y], () => {
        painter.draw({ region, ring: shown.ring, radius, strength }, camera, 1, NEAR_ALONE);
      });
      const { center } = region.entry;
      return found && [found.x + center[0], found.y + center[1], found.z + center[2]];
    },
    along(origin, direction) {
      const open = leg && atlas.find(leg.region);
      if (!open?.shown) return null;
      const { region, shown } = open;
      return along(renderer, picker, minus(origin, region.entry.center), direction, (eye) => {
        painter.draw({ region, ring: shown.ring, radius: shown.grown.radius, strength: null }, eye, 1, NEAR_ALONE);
      });
    },
    shared,
    setGuests: painter.setGuests,
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
    setMapLayer: composer.setMapLayer,
    setVeil: veil.set,
    still(picture, pose) {
      const open = journey && atlas.find(journey.region);
      if (!open) throw new Error('no region is open');
      setPose(pose);
      painter.draw({ ...picture, region: open.region }, camera, 1);
    },
    setDivider: composer.setDivider,
    isMorphedAt: composer.isMorphedAt,
    photo() {
      if (renderer.xr.isPresenting) return Promise.reject(new Error('Pictures are saved outside the headset'));
      if (loss.isLost || !leg || !atlas.find(leg.region)?.shown) {
        return Promise.reject(new Error('There is no picture yet'));
      }
      // In the same task as the drawing: a canvas keeps its picture no longer.
      composer.draw(leg, user);
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
        entry: open?.region.entry ?? null,
        goal: journey?.goal ?? null,
        leaving: leg?.leaving?.region ?? null,
        shown: open?.shown ?? null,
        arrived: open?.arrived ?? -1,
        received: open?.received ?? 0,
        expected: open?.expected ?? 0,
        triangles: open ? trianglesShown(open.region, ring) : { own: 0, drawn: 0 },
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
      picker.dispose();
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
  // Asking waits for the GPU; `programs` asks when that takes no time.
  renderer.debug.checkShaderErrors = false;
  return renderer;
}
