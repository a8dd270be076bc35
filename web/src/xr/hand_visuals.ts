/** What a headset's user sees beside the scene: controllers or hands, and the arc and the ring that aim a jump. */
import {
  CapsuleGeometry,
  Color,
  Group,
  HemisphereLight,
  IcosahedronGeometry,
  InstancedMesh,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  RingGeometry,
  Vector3,
} from 'three';
import type { Input } from './inputs';
import { type Aim, ARC_POINTS } from './teleport';

export type HandVisuals = ReturnType<typeof createHandVisuals>;

/** Number of hands, and number of joints of a hand. */
const [HANDS, JOINTS] = [2, 25] as const;
/** Radius and half length of a controller, radius of the arc's points, and radii of the ring, metres. */
const [CONTROLLER_RADIUS, CONTROLLER_HALF_LENGTH, ARC_POINT_RADIUS] = [0.018, 0.05, 0.012] as const;
const RING = [0.22, 0.3] as const;
const [FREE_COLOR, CLAMPED_COLOR] = [0x4cc2ff, 0xffb84c] as const;

export function createHandVisuals() {
  const group = new Group();
  const body = new MeshLambertMaterial({ color: 0xd5dbe3 });
  // The marks are drawn without depth test, because the ground may lie slightly above the user's floor.
  const mark = new MeshBasicMaterial({ color: FREE_COLOR, depthTest: false });
  const joints = createSpheres(HANDS * JOINTS, body);
  const arcPoints = createSpheres(ARC_POINTS, mark);
  const ring = new Mesh(new RingGeometry(...RING, 48).rotateX(-Math.PI / 2), mark);
  const controllers = Array.from({ length: HANDS }, () => {
    const mesh = new Mesh(new CapsuleGeometry(CONTROLLER_RADIUS, 2 * CONTROLLER_HALF_LENGTH, 4, 12).rotateX(Math.PI / 2), body);
    mesh.matrixAutoUpdate = false;
    return mesh;
  });
  const light = new HemisphereLight(0xffffff, 0x666a70, 2.5);
  const meshes = [...controllers, joints, arcPoints, ring];
  for (const mesh of meshes) mesh.frustumCulled = false;
  group.add(light, ...meshes);
  const colors = { free: new Color(FREE_COLOR), clamped: new Color(CLAMPED_COLOR) };
  const [matrix, scale] = [new Matrix4(), new Vector3()];

  function showControllers(inputs: readonly Input[]): void {
    const grips = inputs.map(({ grip }) => grip).filter((grip) => grip !== null);
    controllers.forEach((mesh, number) => {
      const grip = grips[number];
      mesh.visible = grip !== undefined;
      if (grip) mesh.matrix.fromArray(grip);
    });
  }

  function showJoints(inputs: readonly Input[]): void {
    let count = 0;
    for (const { joints: hand } of inputs) {
      if (!hand) continue;
      for (let joint = 0; joint < hand.radii.length && count < HANDS * JOINTS; joint++) {
        matrix.fromArray(hand.matrices, 16 * joint);
        const radius = hand.radii[joint] ?? 0;
        joints.setMatrixAt(count++, matrix.scale(scale.setScalar(radius)));
      }
    }
    show(joints, count);
  }

  function showAim(aim: Aim | null): void {
    aim?.points.forEach(([x, y, z], number) => {
      matrix.makeScale(ARC_POINT_RADIUS, ARC_POINT_RADIUS, ARC_POINT_RADIUS).setPosition(x, y, z);
      arcPoints.setMatrixAt(number, matrix);
    });
    show(arcPoints, aim?.points.length ?? 0);
    ring.visible = aim !== null;
    if (!aim) return;
    ring.position.set(...aim.target);
    mark.color.copy(aim.isClamped ? colors.clamped : colors.free);
  }

  return {
    group,
    update(inputs: readonly Input[], aim: Aim | null): void {
      showControllers(inputs);
      showJoints(inputs);
      showAim(aim);
    },
    dispose(): void {
      for (const mesh of meshes) mesh.geometry.dispose();
      for (const mesh of [joints, arcPoints]) mesh.dispose();
      for (const material of [body, mark]) material.dispose();
      group.removeFromParent();
    },
  };
}

function createSpheres(count: number, material: Material): InstancedMesh {
  return new InstancedMesh(new IcosahedronGeometry(1, 2), material, count);
}

function show(mesh: InstancedMesh, count: number): void {
  mesh.count = count;
  mesh.visible = count > 0;
  mesh.instanceMatrix.needsUpdate = true;
}
