/** Position and direction of the user as a camera of three.js. */
import { Group, PerspectiveCamera } from 'three';
import type { Point } from '../bundle/manifest';
import type { Floor } from '../control/floor';
import type { Pose } from '../control/pose';

/** Near and far plane, metres. */
const NEAR = 0.05;
const FAR = 30_000;

export interface Viewpoint {
  readonly camera: PerspectiveCamera;
  /** Rig of the headset's space: its position is the user's floor. */
  readonly rig: Group;
  /** Sets the rig relative to a centre, so that coordinates on the GPU are small. */
  place(center: Point): void;
  setPose(pose: Pose): void;
  /** Sets the floor of a headset's user. */
  stand(floor: Floor): void;
}

/** Creates a viewpoint with a vertical field of view, degrees. */
export function createViewpoint(angle: number): Viewpoint {
  const camera = new PerspectiveCamera(angle, 1, NEAR, FAR);
  camera.rotation.order = 'YXZ';
  const rig = new Group();
  rig.add(camera);
  const feet = { x: 0, y: 0, z: 0 };

  function stand({ position: [x, y, z], yaw }: Floor): void {
    Object.assign(feet, { x, y, z });
    rig.rotation.y = yaw;
  }

  return {
    camera,
    rig,
    place(center) {
      rig.position.set(feet.x - center[0], feet.y - center[1], feet.z - center[2]);
      rig.updateMatrixWorld(true);
    },
    setPose({ position: [x, y, z], yaw, pitch }) {
      stand({ position: [x, y, z], yaw: 0 });
      camera.position.set(0, 0, 0);
      camera.rotation.set(pitch, yaw, 0);
    },
    stand,
  };
}
