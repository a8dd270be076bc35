/** Composes a frame of several pictures: of regions and rings that fade, of the divider's sides, of both eyes. */
import { Group, PerspectiveCamera, type WebGLRenderer } from 'three';
import type { Point } from '../bundle/manifest';
import type { Floor } from '../control/floor';
import type { Pose } from '../control/pose';
import type { Atlas } from './atlas';
import type { Leg } from './journey';
import type { Painter } from './painter';
import { cubeOf } from './region';
import type { Cube } from './textures';

/** Composition layer of the headset that can show a map. */
export interface MapLayer {
  /**
   * Sets the cube map; `yaw` is the rotation of the headset's space in the world. Returns true if the layer shows the
   * map in this frame; otherwise the page must draw it.
   */
  show(cube: Cube, yaw: number): boolean;
}

export function createComposer(renderer: WebGLRenderer, atlas: Atlas, painter: Painter, viewpoint: Viewpoint) {
  const { camera, rig, setPose } = viewpoint;
  let divider: number | null = null;
  let mapLayer: MapLayer | null = null;

  /** Draws the picture of a region, morphed or conventional, with an opacity. */
  function drawRegion(number: number, opacity: number, isMorphed: boolean, withMap = true): void {
    const open = atlas.find(number);
    if (!open?.shown || opacity === 0) return;
    const { ring, grown, fading } = open.shown;
    const picture = { region: open.region, radius: grown.radius, strength: isMorphed ? grown.strength : null };
    painter.draw({ ...picture, ring }, camera, opacity, { map: !withMap });
    // While a region fades in, none of its rings fades.
    if (opacity === 1 && fading && fading.share > 0)
      painter.draw({ ...picture, ring: fading.ring }, camera, fading.share);
  }

  /** Draws the region that is left, and over it the current region. */
  function drawLeg({ region, leaving }: Leg, user: Pose | null, isMorphed: boolean): void {
    const before = leaving?.pose ?? user;
    if (leaving && before) {
      setPose(before);
      drawRegion(leaving.region, 1, isMorphed);
    }
    if (user) setPose(user);
    drawRegion(region, leaving?.share ?? 1, isMorphed);
  }

  /**
   * Draws a leg in a headset. Its session sets the pose, so that a region cannot be drawn from the place that a jump
   * has left.
   */
  function drawInHeadset({ region, leaving }: Leg): void {
    if (leaving && !leaving.pose) drawRegion(leaving.region, 1, true);
    drawRegion(region, leaving?.share ?? 1, true, leaving !== null || !isMapInLayer(region));
  }

  /** Whether a composition layer shows the map of a region in this frame. */
  function isMapInLayer(number: number): boolean {
    const open = atlas.find(number);
    if (!open?.shown || open.shown.fading) return false;
    return mapLayer?.show(cubeOf(open.region, open.shown.ring), rig.rotation.y) ?? false;
  }

  /** Draws the conventional picture left of the divider and the continuous one right of it. */
  function drawSides(leg: Leg, user: Pose | null, share: number): void {
    const { clientWidth: width, clientHeight: height } = renderer.domElement;
    const left = Math.round(share * width);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, left, height);
    drawLeg(leg, user, false);
    renderer.setScissor(left, 0, width - left, height);
    drawLeg(leg, user, true);
    renderer.setScissorTest(false);
  }

  return {
    /** Draws a leg for a user. In a headset the pose comes from the session. */
    draw(leg: Leg, user: Pose | null): void {
      if (!atlas.find(leg.region)?.shown) return;
      if (renderer.xr.isPresenting) drawInHeadset(leg);
      else if (divider === null) drawLeg(leg, user, true);
      else drawSides(leg, user, divider);
    },
    /** Sets the divider, left of which the picture is conventional, as a share of the width; null removes it. */
    setDivider(share: number | null): void {
      divider = share;
    },
    /** Whether the picture is continuous at a horizontal position. */
    isMorphedAt: (x: number): boolean => divider === null || x >= divider || renderer.xr.isPresenting,
    /** Sets the layer of a headset that shows the map while nothing fades; null if the page always draws the map. */
    setMapLayer(layer: MapLayer | null): void {
      mapLayer = layer;
    },
  };
}

/** Near plane, metres. */
export const NEAR_PLANE = 0.05;
/** Far plane, metres. */
export const FAR_PLANE = 30_000;

export type Viewpoint = ReturnType<typeof createViewpoint>;

/** Creates a viewpoint with a vertical field of view, degrees. */
export function createViewpoint(angle: number) {
  const camera = new PerspectiveCamera(angle, 1, NEAR_PLANE, FAR_PLANE);
  camera.rotation.order = 'YXZ';
  /** Rig of the headset's space: its position is the user's floor. */
  const rig = new Group();
  rig.add(camera);
  const feet = { x: 0, y: 0, z: 0 };

  /** Sets the floor of a headset's user. */
  function setFloor({ position: [x, y, z], yaw }: Floor): void {
    Object.assign(feet, { x, y, z });
    rig.rotation.y = yaw;
  }

  return {
    camera,
    rig,
    /** Sets the rig relative to a centre, so that coordinates on the GPU are small. */
    place(center: Point): void {
      rig.position.set(feet.x - center[0], feet.y - center[1], feet.z - center[2]);
      rig.updateMatrixWorld(true);
    },
    setPose({ position: [x, y, z], yaw, pitch }: Pose): void {
      setFloor({ position: [x, y, z], yaw: 0 });
      camera.position.set(0, 0, 0);
      camera.rotation.set(pitch, yaw, 0);
    },
    setFloor,
  };
}
