/** Body of the user in each frame, as others see it, and the world point at which its pointer ends. */
import type { WebGLRenderer } from 'three';
import { directionTo } from '../control/floor';
import { addScaled, ahead, type Pose, rightOf, subtract, type Vector } from '../control/pose';
import type { Shared } from '../show/materials';
import type { Guests } from '../show/painter';
import type { Viewer } from '../show/viewer';
import type { HandRay } from '../xr/hands';
import type { FromServer } from './frames';
import type { Hold, ScreenPoint } from './hold';
import { type Body, MAX_COORDINATE, type Placement, rotationAlong, rotationOf } from './pose';
import { invertMorph, type Morph } from './unmorph';

/** Least seconds between two updates of the pointer's target, each of which waits for the GPU. */
const QUERY_INTERVAL = 1 / 36;

/** Creates a function that returns the body; `hands` are null outside the headset, `nearShare` is r1 / r2. */
export function createPointing(
  viewer: Viewer,
  nearShare: number,
  hold: Hold,
  hands: () => readonly HandRay[] | null,
  activity: () => Activity | null,
): (pose: Pose, now: number) => Body {
  const [targets, lengths] = [createThrottled<Vector>(QUERY_INTERVAL), createThrottled<number>(QUERY_INTERVAL)];

  function targetOf(pose: Pose, now: number): Vector | null {
    const { point } = hold;
    if (point) {
      const findTarget = (): Vector =>
        activity()?.targetAt(pose, point) ?? targetAt(viewer, nearShare, pose, point);
      return targets.get(now, findTarget);
    }
    targets.forget();
    return null;
  }

  return (pose, now) => {
    const rays = hands();
    hold.isAlwaysPointing = activity()?.isPointing ?? false;
    if (!hold.isAlwaysPointing && !rays?.some(({ isPointing }) => isPointing)) lengths.forget();
    if (!rays) return bodyAtScreen(pose, targetOf(pose, now));
    return bodyInHeadset(pose, rays, hold.isAlwaysPointing, ({ origin, direction }) =>
      lengths.get(now, () => viewer.along(origin, direction) ?? DEFAULT_RANGE),
    );
  };
}

/** Shared task, whose meshes are drawn like the bodies of other users. */
export interface Activity extends Guests {
  /** Whether users also point without holding a button. */
  readonly isPointing: boolean;
  hear(frame: FromServer, now: number): void;
  /** Updates the task before each frame with the user's pose and the body that others see. */
  frame(pose: Pose, body: Body, now: number): void;
  /** Returns the world point at which a user points in the picture; null for the point of the scene. */
  targetAt(pose: Pose, point: ScreenPoint): Vector | null;
}

/** Metres right, down and ahead from the eyes of a user at a screen to the pointing hand. */
const [HAND_RIGHT, HAND_DOWN, HAND_AHEAD] = [0.22, 0.28, 0.4] as const;

/** Body of a user at a screen: a head, and while the user points, a right hand with a pointer to the target. */
function bodyAtScreen(pose: Pose, target: Vector | null): Body {
  const head: Placement = { position: pose.position, rotation: rotationOf(pose.yaw, pose.pitch) };
  if (!target) return { head, left: null, right: null, pointer: null };
  const side = addScaled(pose.position, rightOf(pose.yaw), HAND_RIGHT);
  const position = addScaled(addScaled(side, ahead({ yaw: pose.yaw, pitch: 0 }), HAND_AHEAD), [0, -1, 0], HAND_DOWN);
  const offset = subtract(target, position);
  const right: Placement = { position, rotation: rotationAlong(offset) };
  return { head, left: null, right, pointer: { begin: 'right', length: Math.min(Math.hypot(...offset), MAX_COORDINATE) } };
}

/**
 * Body of a user in a headset: a head, the tracked hands, and a pointer from the first pointing hand. If the user
 * always points and no hand does, the pointer is that of the right hand or, without one, of the left hand.
 */
function bodyInHeadset(pose: Pose, hands: readonly HandRay[], isAlwaysPointing: boolean, lengthOf: (hand: HandRay) => number): Body {
  const handOf = (side: HandRay['side']): HandRay | undefined => hands.find((hand) => hand.side === side);
  const placementOf = (hand: HandRay | undefined): Placement | null =>
    hand ? { position: hand.origin, rotation: rotationAlong(hand.direction) } : null;
  const defaultHand = isAlwaysPointing ? (handOf('right') ?? hands[0]) : undefined;
  const pointing = hands.find(({ isPointing }) => isPointing) ?? defaultHand;
  return {
    head: { position: pose.position, rotation: rotationOf(pose.yaw, pose.pitch) },
    left: placementOf(handOf('left')),
    right: placementOf(handOf('right')),
    pointer: pointing ? { begin: pointing.side, length: Math.min(lengthOf(pointing), MAX_COORDINATE) } : null,
  };
}

/** Distance assumed for pixels of the map without range, and length of pointers that hit nothing, metres. */
const DEFAULT_RANGE = 100;
/** Least distance assumed for pixels of the map without range, in radii of the morph. */
const MAP_RADII = 2;

/** Current morph of the picture, and the centre to which its positions are relative. */
export function morphOf({ facts }: Viewer, nearShare: number, pose: Pose) {
  const { radius, strength } = facts.shown?.grown ?? { radius: 0, strength: 0 };
  const center: Vector = facts.entry?.center ?? pose.position;
  const morph: Morph = { user: subtract(pose.position, center), inner: nearShare * radius, radius, strength };
  return { center, morph };
}

/**
 * Computes the world point that a point of the picture shows: on near geometry by inverting the morph, which is not
 * applied left of the divider; on the map by the range from the centre.
 */
function targetAt(viewer: Viewer, nearShare: number, pose: Pose, [x, y]: ScreenPoint): Vector {
  const { center, morph } = morphOf(viewer, nearShare, pose);
  const nearPoint = viewer.pointAt(x, y);
  if (nearPoint) {
    const unmorphed = viewer.isMorphedAt(x) ? invertMorph(subtract(nearPoint, pose.position), morph) : null;
    return unmorphed ? addScaled(center, unmorphed, 1) : nearPoint;
  }
  const { camera, renderer, shared } = viewer;
  const direction = directionTo(pose, [x, y], camera);
  const range = readRange(renderer, shared, direction) ?? Math.max(DEFAULT_RANGE, MAP_RADII * morph.radius);
  return addScaled(center, direction, range);
}

/** Code of pixels without a range. */
const NO_RANGE = 65535;

/** Returns the texel of a cube map that WebGL samples for a direction. */
export function texelOf([x, y, z]: Vector, size: number) {
  const [ax, ay, az] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  const longest = Math.max(ax, ay, az);
  const [face, across, down] =
    ax === longest ? (x > 0 ? [0, -z, -y] : [1, z, -y])
    : ay === longest ? (y > 0 ? [2, x, z] : [3, x, -z])
    : z > 0 ? [4, x, -y] : [5, -x, -y];
  const place = (value: number): number => Math.min(Math.floor((value / longest + 1) * 0.5 * size), size - 1);
  return { face, x: place(across), y: place(down) };
}

/** Reads the range from the centre in the map of the last picture, metres; null if there is none. */
function readRange(renderer: WebGLRenderer, { codes, coding }: Shared, direction: Vector): number | null {
  const { x: least, y: step, z: size, w: hasRange } = coding.value;
  const { __webglTexture: texture } = renderer.properties.get(codes.value) as { __webglTexture?: WebGLTexture };
  if (hasRange === 0 || !texture) return null;
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { face, x, y } = texelOf(direction, size);
  const frame = gl.createFramebuffer();
  const code = new Uint32Array(4);
  renderer.state.bindFramebuffer(gl.FRAMEBUFFER, frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, texture, 0);
  gl.readPixels(x, y, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, code);
  renderer.state.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(frame);
  const [rangeCode = NO_RANGE] = code;
  return rangeCode === NO_RANGE ? null : least * Math.exp(rangeCode * step);
}

/** Creates a cache of a value, which is computed at most once in `seconds`. */
export function createThrottled<Value>(seconds: number) {
  let cached: { readonly value: Value; readonly end: number } | null = null;
  return {
    /** Returns the cached value; calls `compute` if it is too old or was discarded. */
    get(now: number, compute: () => Value): Value {
      if (!cached || now >= cached.end) cached = { value: compute(), end: now + seconds };
      return cached.value;
    },
    forget(): void {
      cached = null;
    },
  };
}
