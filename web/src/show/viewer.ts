/** Viewer: draws the picture on the screen, frame by frame. */
import { type Group, type PerspectiveCamera, Scene, type WebGLRenderer } from 'three';
import type { Fetch } from '../bundle/source';
import type { Floor } from '../control/floor';
import { type Pose, subtract, type Vector } from '../control/pose';
import { createAtlas } from './atlas';
import { createStore } from './buffers';
import { createComposer, createViewpoint, type MapLayer } from './composer';
import { type DecoderWorker, startDecoder } from './decoder';
import type { Loading } from './job';
import { type Facts, factsOf } from './facts';
import { createJourney, type Journey, type Leg } from './journey';
import { createShared, type Shared } from './materials';
import { createPainter, createVeil, type Guests, type Picture } from './painter';
import { castRay, createPicker } from './pick';
import { createPrograms } from './programs';
import { createRenderer, resolveOnce, watchLoss } from './renderer';
import type { Manner } from './stage';
import { createCube } from './textures';
import { createFlight, createUploads, type Uploads } from './uploads';
import type { World } from './world';

/** Omitted parts when a picture serves to locate near geometry. */
const NEAR_ALONE = { map: true, guests: true } as const;
/** Budget in milliseconds per frame for uploads and answers of workers: docs/view.md. */
const UPLOAD_BUDGET = 3;
export interface Settings extends Manner {
  readonly world: World;
  readonly fetch: Fetch;
  readonly worker: URL;
  /** Vertical field of view, degrees. */
  readonly angle: number;
  readonly antialias: boolean;
  readonly failed: (reason: Error) => void;
  /** Called when the user was moved to another place, for which frames are drawn from then on. */
  readonly moved: (pose: Pose) => void;
  /** Called when the graphics context is lost, or restored them. */
  readonly lost: (isLost: boolean) => void;
}

export interface Viewer {
  /** Queue of uploads to the GPU, for measurements. */
  readonly uploads: Uploads;
  readonly renderer: WebGLRenderer;
  readonly camera: PerspectiveCamera;
  /** Rig of the headset's space: its position is the user's floor. */
  readonly rig: Group;
  /** Texels along an edge of a map. */
  readonly faceSize: number;
  /** Begins in a region from its ring 0; closes all others. */
  open(number: number): void;
  /** Moves to another place by a cross-fade when its region can be shown. */
  go(target: Pose): void;
  /** Returns the shown position of near geometry at x and y, from 0 to 1 from the upper left; null for none. */
  pointAt(x: number, y: number): Vector | null;
  /** Returns the distance in metres along a world ray to unmorphed near geometry; null without a hit. */
  along(origin: Vector, direction: Vector): number | null;
  /** Uniforms of the pictures, for materials of guests. */
  readonly shared: Shared;
  /** Sets the other users to draw; null for none. */
  setGuests(guests: Guests | null): void;
  /** Reloads what failed. */
  retry(): void;
  /** Draws a frame for a user, some seconds after the one before. In a headset the pose comes from the session. */
  frame(pose: Pose, seconds: number): void;
  /** Sets the floor of a headset's user. */
  stand(floor: Floor): void;
  /** Sets the headset layer that shows the map while nothing fades; null to draw the map. */
  setMapLayer(layer: MapLayer | null): void;
  /** Sets the darkness of the picture, from 0 to 1 for black. */
  setVeil(darkness: number): void;
  /** Draws one state regardless of time, for tests and screenshots. */
  still(picture: Omit<Picture, 'region'>, pose: Pose): void;
  /** Sets the divider, left of which the picture is conventional, as a share of the width; null removes it. */
  setDivider(share: number | null): void;
  /** Whether the picture is continuous at a horizontal position. */
  isMorphedAt(x: number): boolean;
  /** Returns the last picture as PNG. */
  photo(): Promise<Blob>;
  readonly facts: Facts;
  dispose(): void;
}

export function createViewer(canvas: HTMLCanvasElement, settings: Settings): Viewer {
  const { faceSize, fade, marginShare, nearShare, places } = settings.world;
  const renderer = createRenderer(canvas, settings.antialias);
  const viewpoint = createViewpoint(settings.angle);
  const { camera, rig, setPose, stand } = viewpoint;
  const veil = createVeil();
  // Overlay of the picture: a headset's additions to the rig, and the veil.
  const overlay = new Scene();
  overlay.add(rig, veil.mesh);
  // Map of one texel until the first one is loaded: samplers need textures of their type.
  let blank = createCube(renderer, 1);
  const shared = createShared(blank.color, blank.codes);
  const flight = createFlight(renderer.getContext() as WebGL2RenderingContext);
  const uploads = createUploads(() => performance.now(), flight);
  const start = (): DecoderWorker => startDecoder(settings.worker, uploads.spend);
  const workers: DecoderWorker[] = [start(), start()];
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
    geometry: (workers[0] as DecoderWorker).decode,
    maps: (workers[1] as DecoderWorker).decode,
    fetch: settings.fetch,
    programs,
    warm(meshes) {
      // An empty draw makes three.js create everything that the first draw of a mesh needs.
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

  /** Begins in a region with nothing loaded. */
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
      return castRay(renderer, picker, subtract(origin, region.entry.center), direction, (eye) => {
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
      if (renderer.xr.isPresenting) return Promise.reject(new Error('Leave the headset to save a picture'));
      if (loss.isLost || !leg || !atlas.find(leg.region)?.shown) {
        return Promise.reject(new Error('There is no picture yet'));
      }
      // In the same task as the drawing, because the canvas is cleared afterwards.
      composer.draw(leg, user);
      return new Promise((done, failed) => {
        canvas.toBlob((blob) => (blob ? done(blob) : failed(new Error('The browser cannot encode the picture'))), 'image/png');
      });
    },
    get facts() {
      return factsOf(journey, leg, atlas, store, upload);
    },
    dispose() {
      atlas.dispose();
      for (const worker of workers) worker.dispose();
      blank.dispose();
      picker.dispose();
      loss.dispose();
      renderer.dispose();
      // Browsers limit the number of contexts; this one is not left to the garbage collector.
      renderer.forceContextLoss();
    },
  };
}
