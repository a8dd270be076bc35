/** The viewer: loads regions and draws the picture, frame by frame. */
import { type PerspectiveCamera, Scene } from 'three';
import type { RegionEntry } from '../bundle/manifest';
import type { Fetch } from '../bundle/source';
import type { Bounds } from '../control/limit';
import { addScaled, type Pose, subtract, type Vector } from '../control/pose';
import type { Triangles } from '../decode/messages';
import { type Atlas, type AtlasFacts, createAtlas, type OpenRegion } from './atlas';
import { createStore, type Store } from './buffers';
import { createComposer, createViewpoint } from './composer';
import { startDecoder } from './decoder';
import type { Loading } from './loader';
import { createJourney, type Journey, type Leg } from './journey';
import { createShared } from './materials';
import { createPainter, createVeil, type Picture } from './painter';
import { castRay, createPicker } from './pick';
import { createPrograms } from './programs';
import { countTriangles } from './region';
import { createRenderer, resolveOnce, watchLoss } from './renderer';
import type { Manner } from './stage';
import { createCube } from './textures';
import { createFlight, createUploads } from './uploads';
import type { World } from './world';

/** Parts that are not drawn when a point of near geometry is looked for. */
const GEOMETRY_ONLY = { map: true, guests: true } as const;
/** Milliseconds of each frame for uploads and for answers of workers: docs/view.md. */
const UPLOAD_BUDGET_MS = 3;

export interface Settings extends Manner {
  readonly world: World;
  readonly fetch: Fetch;
  readonly worker: URL;
  /** Vertical field of view, degrees. */
  readonly angle: number;
  readonly antialias: boolean;
  readonly onFailure: (reason: Error) => void;
  /** Called when a jump moves the user; the next frames must be drawn from this pose. */
  readonly onMove: (pose: Pose) => void;
  /** Called when the graphics context is lost, and when it is restored. */
  readonly onLoss: (isLost: boolean) => void;
}

export type Viewer = ReturnType<typeof createViewer>;

export function createViewer(canvas: HTMLCanvasElement, settings: Settings) {
  const { faceSize, fade, marginShare, nearShare, places } = settings.world;
  const renderer = createRenderer(canvas, settings.antialias);
  const viewpoint = createViewpoint(settings.angle);
  const { camera, rig, setPose, setFloor } = viewpoint;
  const veil = createVeil();
  // Drawn over the picture: the user's hands in a headset, and the veil.
  const overlay = new Scene();
  overlay.add(rig, veil.mesh);
  // Map of one texel, because samplers need a texture even before the first map is loaded.
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
      // When three.js draws no triangles of a mesh, it still creates everything that it needs to draw the mesh.
      for (const { geometry } of meshes) geometry.setDrawRange(0, 0);
      warmUpScene.children = [...meshes];
      renderer.render(warmUpScene, camera);
      warmUpScene.children = [];
      for (const { geometry } of meshes) geometry.setDrawRange(0, Infinity);
    },
  };
  const atlas = createAtlas(settings.world, loading, settings, (region, reason) => {
    journey?.abandon(region);
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
      closeAll();
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

  function closeAll(): void {
    for (const region of atlas.facts.regions) atlas.close(region);
    journey = leg = null;
  }

  /** Closes all regions and opens one, which begins with its ring 0. */
  function begin(number: number): void {
    closeAll();
    const onMove = (pose: Pose): void => {
      user = pose;
      settings.onMove(pose);
    };
    journey = createJourney({ places, marginShare, fade, onMove }, atlas, number);
  }

  function resizeCanvas(): void {
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
    // While a region fades in, its own picture does not change.
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
    /** Moves the user to another place, by a cross-fade, as soon as its region can be shown. */
    go: (target: Pose): void => journey?.go(target),
    /** Returns the point where near geometry appears at x and y, 0 to 1 from the upper left; null for none. */
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
    /** Returns the distance in metres along a world ray to near geometry without morph; null if the ray meets none. */
    along(origin: Vector, direction: Vector): number | null {
      const open = leg && atlas.find(leg.region);
      if (!open?.shown) return null;
      const { region, shown } = open;
      const picture = { region, ring: shown.ring, radius: shown.grown.radius, strength: null };
      const draw = (eye: PerspectiveCamera): void => painter.draw(picture, eye, 1, GEOMETRY_ONLY);
      return castRay(renderer, picker, subtract(origin, region.entry.center), direction, draw);
    },
    /** Uniforms of the picture, for the materials of guests. */
    shared,
    setGuests: painter.setGuests,
    retry: atlas.retry,
    /** Draws a frame for a user, some seconds after the one before. In a headset, its session sets the drawn pose. */
    frame(pose: Pose, seconds: number): void {
      user = pose;
      if (loss.isLost) return;
      resizeCanvas();
      const { isPresenting } = renderer.xr;
      if (isPresenting) resolveOnce(renderer, () => advance(pose, seconds));
      else advance(pose, seconds);
      if (isPresenting || veil.mesh.visible) renderer.render(overlay, camera);
    },
    setFloor,
    setMapLayer: composer.setMapLayer,
    setVeil: veil.set,
    /** Draws a picture of the current region in any state, for tests and screenshots. */
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
      // The canvas is read in the same task, because the browser clears it afterwards.
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
      // Browsers limit the number of contexts, and the garbage collector may free this one late.
      renderer.forceContextLoss();
    },
  };
}

/** Facts of the picture, for the panel and for tests. */
export interface Facts extends AtlasFacts, Readonly<Pick<OpenRegion, 'shown' | 'arrived' | 'received' | 'expected'>> {
  readonly region: number;
  /** Entry of the region; null before its manifest is loaded. */
  readonly entry: RegionEntry | null;
  /** Region that the user jumps to; null for none. */
  readonly goal: number | null;
  readonly triangles: Triangles;
  /** Milliseconds of the last frame for uploads and for answers of workers. */
  readonly upload: number;
  /** Area where the user may be. */
  readonly bounds: Bounds | null;
  /** Region whose picture fades out; null for none. */
  readonly leaving: number | null;
  /** Number of arrays that several meshes share. */
  readonly shared: number;
}

/** Returns the facts of a journey and its last leg; both are null before the first region is open. */
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
    triangles: open ? countTriangles(open.region, ring) : { inFile: 0, drawn: 0 },
    upload,
    bounds: journey?.bounds ?? null,
    ...atlas.facts,
    shared: store.shared,
  };
}
