/** Orbiting a point in the middle of the picture; independent of a browser. */
import type { Drive } from './drive';
import { allowedShare, type Bounds, confine, leadBack } from './limit';
import { addScaled, ahead, clamp, MAX_PITCH, type Pose, rightOf, upOf, type Vector } from './pose';

/** Least and greatest distance from the point, and the default distance, metres. */
const [MIN_DISTANCE, MAX_DISTANCE, DEFAULT_DISTANCE] = [0.3, 2000, 4] as const;
/** Full speed: radians per second, zoom exponent per second, and pan distances per second. */
const [TURN, ZOOM, PAN] = [1.4, 1.2, 0.8] as const;

export function createOrbit(start: Pose, bounds: () => Bounds | null) {
  let view: Pose = start;
  let distance: number = DEFAULT_DISTANCE;

  const target = (): Vector => addScaled(view.position, ahead(view), distance);

  /** Places the eye and turns it towards a point. */
  function lookAt(eye: Vector, point: Vector): void {
    const [x, y, z] = addScaled(point, eye, -1);
    const horizontal = Math.hypot(x, z);
    distance = clamp(Math.hypot(horizontal, y), MIN_DISTANCE, MAX_DISTANCE);
    const yaw = horizontal > 1e-9 ? equivalentAngle(Math.atan2(-x, -z), view.yaw) : view.yaw;
    view = { position: eye, yaw, pitch: clamp(Math.atan2(y, horizontal), -MAX_PITCH, MAX_PITCH) };
  }

  /** Orbits; the view turns by `left` and `up` radians. */
  function rotate(left: number, up: number): void {
    if (left === 0 && up === 0) return;
    const point = target();
    const turned = { yaw: view.yaw + left, pitch: clamp(view.pitch + up, -MAX_PITCH, MAX_PITCH) };
    const eye = addScaled(point, ahead(turned), -distance);
    const allowed = confine(view.position, eye, bounds());
    if (allowed === eye) view = { ...turned, position: eye };
    else lookAt(allowed, point);
  }

  /** Multiplies the distance. */
  function zoom(factor: number): void {
    if (!(factor > 0) || factor === 1) return;
    const newDistance = clamp(distance * factor, MIN_DISTANCE, MAX_DISTANCE);
    const eye = addScaled(target(), ahead(view), -newDistance);
    const share = allowedShare(view.position, eye, bounds());
    const position = addScaled(view.position, ahead(view), share * (distance - newDistance));
    distance += share * (newDistance - distance);
    view = { ...view, position };
  }

  /** Moves the eye and the point to the right and up in the picture, by multiples of their distance. */
  function pan(right: number, up: number): void {
    const shift = addScaled(addScaled([0, 0, 0], rightOf(view.yaw), right * distance), upOf(view), up * distance);
    const share = allowedShare(view.position, addScaled(view.position, shift, 1), bounds());
    view = { ...view, position: addScaled(view.position, shift, share) };
  }

  return {
    get pose(): Pose {
      return view;
    },
    /** Advances by some seconds. Steps aside and turns orbit, steps ahead zoom in; while running, steps pan. */
    update(seconds: number, { right, ahead: nearer, turn, look, isRunning }: Drive): void {
      if (isRunning) pan(PAN * seconds * right, PAN * seconds * nearer);
      else zoom(Math.exp(-ZOOM * seconds * nearer));
      const turnLeft = isRunning ? turn : turn - right;
      rotate(TURN * seconds * turnLeft, TURN * seconds * look);
      view = { ...view, position: leadBack(view.position, bounds(), seconds) };
    },
    rotate,
    zoom,
    pan,
    /** Continues from a pose; the point is ahead at the default distance. */
    setPose(pose: Pose): void {
      view = pose;
      distance = DEFAULT_DISTANCE;
    },
  };
}

/** Angle equivalent to `angle` and nearest to `other`, so that views turn the short way. */
function equivalentAngle(angle: number, other: number): number {
  return angle + 2 * Math.PI * Math.round((other - angle) / (2 * Math.PI));
}
