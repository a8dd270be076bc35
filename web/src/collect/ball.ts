/**
 * Sphere in the picture. Its colour shows how many users aim at it, and a ring around it shows for how long all of them
 * have aimed.
 */
import { Color, Matrix4, SphereGeometry, Vector3, Vector4 } from 'three';
import type { Point } from '../bundle/manifest';
import { directionTo } from '../control/floor';
import { addScaled, type Pose, subtract, type Vector } from '../control/pose';
import type { ScreenPoint } from '../rooms/hold';
import { createMesh, createRibbon, type DrawnMesh } from '../rooms/meshes';
import { morphOf } from '../rooms/pointing';
import { HEAD } from '../rooms/shaders';
import { applyMorph } from '../rooms/unmorph';
import { NEAR_VERTEX } from '../shaders/scene';
import type { Shared } from '../show/materials';
import type { Viewer } from '../show/viewer';

/** Colours for no aiming user, some, all, and for the remaining part of the ring. */
const [NONE_COLOR, SOME_COLOR, ALL_COLOR, REMAINING_COLOR] = ['#e6ebf2', '#ffb52e', '#35d07f', '#3a434e'].map((name) => new Color(name));
/** Number of segments of the ring. */
const SEGMENTS = 96;

export function createBall(shared: Shared) {
  const color = new Vector4(1, 1, 1, 1);
  const [placement, begin, size] = [new Matrix4(), new Vector3(), { value: 1 }];
  const body = createMesh(new SphereGeometry(1, 40, 28), shared, NEAR_VERTEX, { SMOOTH: '' }, {
    base_color: { value: color },
    placement: { value: placement },
  });
  const arc = (ringColor: Color | undefined, shares: { value: number[] }): DrawnMesh =>
    createMesh(createRibbon(SEGMENTS, 0), shared, RING_VERTEX, { UNLIT: '' }, {
      base_color: { value: new Vector4(ringColor?.r, ringColor?.g, ringColor?.b, 1) },
      begin: { value: begin },
      radius: size,
      shares,
    });
  const [doneShares, remainingShares] = [{ value: [0, 0] }, { value: [0, 1] }];
  const shapes = [body, arc(ALL_COLOR, doneShares), arc(REMAINING_COLOR, remainingShares)];
  let meshes: readonly DrawnMesh[] = [];
  let position: Vector = [0, 0, 0];

  return {
    get meshes(): readonly DrawnMesh[] {
      return meshes;
    },
    /** Sets world position, radius, the share of users who aim at it, and the elapsed share of the holding time. */
    show(center: Vector | null, radius: number, aimShare: number, heldShare: number): void {
      meshes = center ? shapes : [];
      if (!center) return;
      position = center;
      size.value = radius;
      const { r, g, b } = (aimShare >= 1 ? ALL_COLOR : aimShare > 0 ? SOME_COLOR : NONE_COLOR) ?? new Color();
      color.set(r, g, b, 1);
      doneShares.value = [0, heldShare];
      remainingShares.value = [heldShare, 1];
    },
    /** Places the sphere for pictures that have this centre at the origin. */
    place(center: Point): void {
      begin.set(...subtract(position, center));
      placement.makeScale(size.value, size.value, size.value).setPosition(begin);
    },
  };
}

/** Vertex shader of the ring around a sphere; its fragment shader is that of near geometry. */
const RING_VERTEX = /* glsl */ `
${HEAD}
// x: share of the drawn part of the turn; y: 0 inside, 1 outside.
in vec3 position;
uniform vec3 begin;
uniform float radius;
// Shares of a turn, clockwise from the top, between which the ring is drawn.
uniform float shares[2];
// Inner and outer radius in radii of the sphere.
const vec2 RING = vec2(1.25, 1.45);

void main() {
  v_point = begin;
  vec3 from_eye = displayed(v_point);
  mat3 axes = facing(from_eye);
  float angle = 6.2831853 * mix(shares[0], shares[1], position.x);
  float size = radius * mix(RING.x, RING.y, position.y);
  v_shown = from_eye + size * (sin(angle) * axes[0] + cos(angle) * axes[1]);
  gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * v_shown, 1.0);
}
`;

/** Directions count as pointing at the sphere up to this tangent of their angle to the sphere's centre. */
const MAX_TANGENT = 0.5;

/**
 * World point that is shown at a point of the picture, at the sphere's distance. A hand beside the eyes that points at
 * this point hits the sphere exactly if the user's view does. Null for directions far from the sphere.
 */
export function pointAtDistance(
  viewer: Viewer,
  nearShare: number,
  pose: Pose,
  point: ScreenPoint,
  sphere: Vector,
): Vector | null {
  const { center, morph } = morphOf(viewer, nearShare, pose);
  const shownCenter = applyMorph(subtract(sphere, center), morph);
  const [dx, dy, dz] = directionTo(pose, point, viewer.camera);
  const distanceAlong = shownCenter[0] * dx + shownCenter[1] * dy + shownCenter[2] * dz;
  const offset = subtract([distanceAlong * dx, distanceAlong * dy, distanceAlong * dz], shownCenter);
  return distanceAlong > 0 && Math.hypot(...offset) <= MAX_TANGENT * distanceAlong ? addScaled(sphere, offset, 1) : null;
}
