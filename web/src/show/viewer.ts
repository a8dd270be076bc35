/** Viewer: draws the picture on the screen, frame by frame. */
import { type PerspectiveCamera, Scene } from 'three';
import type { RegionEntry } from '../bundle/manifest';
import type { Fetch } from '../bundle/source';
import type { Bounds } from '../control/limit';
import { addScaled, type Pose, subtract, type Vector } from '../control/pose';
import type { Triangles } from '../decode/messages';
import { type Atlas, createAtlas, type Holding, type OpenRegion } from './atlas';
import { createStore, type Store } from './buffers';
import { createComposer, createViewpoint } from './composer';
import { startDecoder } from './decoder';
import type { Loading } from './loader';
import { createJourney, type Journey, type Leg } from './journey';
import { createShared } from './materials';
import { createPainter, createVeil, type Picture } from './painter';
import { castRay, createPicker } from './pick';
import { createPrograms } from './programs';
import { trianglesShown } from './region';
import { createRenderer, resolveOnce, watchLoss } from './renderer';
import type { Manner } from './stage';
import { createCube } from './textures';
import { createFlight, createUploads } from './uploads';
import type { World } from './world';

/** Omitted parts when a picture serves to locate near geometry. */
const GEOMETRY_ONLY = { map: true, guests: true } as const;
/** Budget in milliseconds per frame for uploads and answers of workers: docs/view.md. */
const UPLOAD_BUDGET_MS = 3;

export interface Settings extends Manner {
  readonly world: World;
  readonly fetch: Fetch;
  readonly worker: URL;
  /** Vertical field of view, degrees. */
  readonly angle: number;
  readonly antialias: boolean;
  readonly onFailure: (reason: Error) => void;
  /** Called when the user was moved to another place, for which frames are drawn from then on. */
  readonly onMove: (pose: Pose) => void;
  /** Called when the graphics context is lost, and when it is restored. */
  readonly onLoss: (isLost: boolean) => void;
}

export type Viewer = ReturnType<typeof createViewer>;

export function createViewer(canvas: HTMLCanvasElement, settings: Settings) {
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
  const geometryWorker = startDecoder(settings.worker, uploads.spend);
  const mapWorker = startDecoder(settings.worker, uploads.spend);
  const painter = createPainter(renderer, shared, nearShare, () => blank, viewpoint.place);
  painter.prepare(camera);
  const picker = createPicker(renderer);
  const programs = createPrograms(renderer, camera, shared, uploads);
  const warmUpScene = new Scene();
  const store = createStore();
  const loading: Loading = {
    renderer,
    shared,
    store,
    uploads,
    geometry: geometryWorker.decode,
    maps: mapWorker.decode,
    fetch: settings.fetch,
    programs,
    warmUp(meshes) {
      // An empty draw makes three.js create everything that the first draw of a mesh needs.
      for (const { geometry } of meshes) geometry.setDrawRange(0, 0);
      warmUpScene.children = [...meshes];
      renderer.render(warmUpScene, camera);
      warmUpScene.children = [];
      for (const { geometry } of meshes) geometry.setDrawRange(0, Infinity);
    },
  };
  const atlas = createAtlas(settings.world, loading, settings, (region, reason) => {
    journey?.failed(region);
    settings.onFailure(reason);
  });
  const composer = createComposer(renderer, atlas, painter, viewpoint);
  let journey: Journey | null = null;
  let leg: Leg | null = null;
  let user: Pose | null = null;
  let upload = 0;

  let regionBeforeLoss: number | null = null;
  const loss = watchLoss(
    canvas,
    () => {
      regionBeforeLoss = journey?.region ?? null;
      close();
      blank.dispose();
      picker.dispose();
      programs.forget();
      uploads.forget();
      settings.onLoss(true);
    },
    () => {
      renderer.setClearAlpha(0);
      blank = createCube(renderer, 1);
      [shared.map.value, shared.codes.value] = [blank.color, blank.codes];
      painter.prepare(camera);
      if (regionBeforeLoss !== null) begin(regionBeforeLoss);
      settings.onLoss(false);
    },
  );

  function close(): void {
    for (const region of atlas.holding.regions) atlas.close(region);
    journey = leg = null;
  }

  /** Begins in a region from its ring 0; closes all others. */
  function begin(number: number): void {
    close();
    const onMove = (pose: Pose): void => {
      user = pose;
      settings.onMove(pose);
    };
    journey = createJourney({ places, marginShare, fade, onMove }, atlas, number);
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
    upload = uploads.run(UPLOAD_BUDGET_MS);
    if (!journey) return;
    leg = journey.advance(seconds, pose);
    // Nothing else changes while a region fades in.
    atlas.advance(leg.region, leg.leaving ? 0 : seconds, journey.minRadius);
    composer.draw(leg, user);
  }

  return {
    /** Queue of uploads to the GPU, for measurements. */
    uploads,
    renderer,
    camera,
    /** Rig of the headset's space: its position is the user's floor. */
    rig,
    /** Texels along an edge of a map. */
    faceSize,
    open: begin,
    /** Moves to another place by a cross-fade when its region can be shown. */
    go: (target: Pose): void => journey?.go(target),
    /** Returns the shown position of near geometry at x and y, from 0 to 1 from the upper left; null for none. */
    pointAt(x: number, y: number): Vector | null {
      const open = leg && atlas.find(leg.region);
      if (!open?.shown || !user) return null;
      const { region, shown } = open;
      setPose(user);
      const { radius } = shown.grown;
      const strength = composer.isMorphedAt(x) ? shown.grown.strength : null;
      const picture = { region, ring: shown.ring, radius, strength };
      const point = picker.pick(camera, [x, y], () => painter.draw(picture, camera, 1, GEOMETRY_ONLY));
      return point && addScaled(point.toArray(), region.entry.center, 1);
    },
    /** Returns the distance in metres along a world ray to unmorphed near geometry; null without a hit. */
    along(origin: Vector, direction: Vector): number | null {
      const open = leg && atlas.find(leg.region);
      if (!open?.shown) return null;
      const { region, shown } = open;
      const picture = { region, ring: shown.ring, radius: shown.grown.radius, strength: null };
      const draw = (eye: PerspectiveCamera): void => painter.draw(picture, eye, 1, GEOMETRY_ONLY);
      return castRay(renderer, picker, subtract(origin, region.entry.center), direction, draw);
    },
    /** Uniforms of the pictures, for materials of guests. */
    shared,
    setGuests: painter.setGuests,
    retry: atlas.retry,
    /** Draws a frame for a user, some seconds after the one before. In a headset the pose comes from the session. */
    frame(pose: Pose, seconds: number): void {
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
    /** Draws one state regardless of time, for tests and screenshots. */
    still(picture: Omit<Picture, 'region'>, pose: Pose): void {
      const open = journey && atlas.find(journey.region);
      if (!open) throw new Error('no region is open');
      setPose(pose);
      painter.draw({ ...picture, region: open.region }, camera, 1);
    },
    setDivider: composer.setDivider,
    isMorphedAt: composer.isMorphedAt,
    /** Returns the last picture as PNG. */
    async photo(): Promise<Blob> {
      if (renderer.xr.isPresenting) throw new Error('Leave the headset to save a picture');
      if (loss.isLost || !leg || !atlas.find(leg.region)?.shown) throw new Error('There is no picture yet');
      // In the same task as the drawing, because the canvas is cleared afterwards.
      composer.draw(leg, user);
      const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
      if (!blob) throw new Error('The browser cannot encode the picture');
      return blob;
    },
    get facts(): Facts {
      return factsOf(journey, leg, atlas, store, upload);
    },
    dispose(): void {
      atlas.dispose();
      for (const resource of [geometryWorker, mapWorker, blank, picker, loss, renderer]) resource.dispose();
      // Browsers limit the number of contexts; this one is not left to the garbage collector.
      renderer.forceContextLoss();
    },
  };
}

/** Facts of the picture, for the panel and for tests. */
export interface Facts extends Holding, Readonly<Pick<OpenRegion, 'shown' | 'arrived' | 'received' | 'expected'>> {
  readonly region: number;
  /** Entry of the region; null before its manifest is loaded. */
  readonly entry: RegionEntry | null;
  /** Region that the user is moving to; null for none. */
  readonly goal: number | null;
  readonly triangles: Triangles;
  /** Milliseconds spent on uploads and answers of workers in the last frame. */
  readonly upload: number;
  /** Area where the user may be. */
  readonly bounds: Bounds | null;
  /** Region whose picture fades out; null for none. */
  readonly leaving: number | null;
  /** Number of arrays that several meshes share. */
  readonly shared: number;
}

/** Facts of a journey and its last leg; both are null before a region is open. */
function factsOf(journey: Journey | null, leg: Leg | null, atlas: Atlas, store: Store, upload: number): Facts {
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
    triangles: open ? trianglesShown(open.region, ring) : { inFile: 0, drawn: 0 },
    upload,
    bounds: journey?.bounds ?? null,
    ...atlas.holding,
    shared: store.shared,
  };
}
