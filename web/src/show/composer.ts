/** Composes a frame of pictures: of regions and rings that fade, of both sides of the divider, for both eyes. */
import type { WebGLRenderer } from 'three';
import type { Pose } from '../control/pose';
import type { Atlas } from './atlas';
import type { Cube } from './cubes';
import type { Leg } from './journey';
import type { Painter } from './picture';
import { cubeOf } from './region';
import type { Viewpoint } from './viewpoint';

/** A layer of the headset's own that can show a map. */
export interface MapLayer {
  /**
   * Hold the map of a cube, for a headset whose space is turned by a yaw in the world. True if the layer shows just
   * that in this frame; else the map must be drawn.
   */
  show(cube: Cube, yaw: number): boolean;
}

export interface Composer {
  /** Draw what a leg shows to a user. In a headset the pose is what it tells. */
  draw(leg: Leg, user: Pose | null): void;
  /** Part of the width, from the left, in which the picture is the conventional one; null for none. */
  setDivider(share: number | null): void;
  /** Whether the picture is the continuous one at a part of its width. */
  isMorphedAt(x: number): boolean;
  /** Let a layer of the headset show the map while nothing fades; null to draw it. */
  setMapLayer(layer: MapLayer | null): void;
}

export function createComposer(
  renderer: WebGLRenderer,
  atlas: Atlas,
  painter: Painter,
  { camera, rig, setPose }: Viewpoint,
): Composer {
  let divider: number | null = null;
  let mapLayer: MapLayer | null = null;

  /** Draw what is shown of a region, morphed or conventional, as a share over what is there. */
  function paint(number: number, opacity: number, isMorphed: boolean, withMap = true): void {
    const open = atlas.find(number);
    if (!open?.shown || opacity === 0) return;
    const { ring, grown, fading } = open.shown;
    const picture = { region: open.region, radius: grown.radius, strength: isMorphed ? grown.strength : null };
    painter.draw({ ...picture, ring }, camera, opacity, { map: !withMap });
    // While a region fades in, nothing in it does.
    if (opacity === 1 && fading && fading.share > 0) {
      painter.draw({ ...picture, ring: fading.ring }, camera, fading.share);
    }
  }

  /** Draw the picture of a region over the one that it takes over from. */
  function paintLeg({ region, leaving }: Leg, user: Pose | null, isMorphed: boolean): void {
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

  /** Left of the divider the conventional picture, right of it the continuous one. */
  function paintSides(leg: Leg, user: Pose | null, share: number): void {
    const { clientWidth: width, clientHeight: height } = renderer.domElement;
    const left = Math.round(share * width);
    renderer.setScissorTest(true);
    renderer.setScissor(0, 0, left, height);
    paintLeg(leg, user, false);
    renderer.setScissor(left, 0, width - left, height);
    paintLeg(leg, user, true);
    renderer.setScissorTest(false);
  }

  return {
    draw(leg, user) {
      if (!atlas.find(leg.region)?.shown) return;
      if (renderer.xr.isPresenting) paintEyes(leg);
      else if (divider === null) paintLeg(leg, user, true);
      else paintSides(leg, user, divider);
    },
    setDivider(share) {
      divider = share;
    },
    isMorphedAt: (x) => divider === null || x >= divider || renderer.xr.isPresenting,
    setMapLayer(layer) {
      mapLayer = layer;
    },
  };
}
