/** Drawing of a sphere: its colour shows how many users aim at it, a ring around it for how long all have. */
import { BufferAttribute, BufferGeometry, Color, Matrix4, SphereGeometry, Vector3, Vector4 } from 'three';
import type { Point } from '../bundle/manifest';
import { minus, type Vector } from '../control/vector';
import { NEAR_VERTEX } from '../shaders/near';
import type { Shared } from '../show/materials';
import { type Drawn, createMesh } from '../rooms/drawn';
import { RING_VERTEX } from './shaders';

/** Colours for no aiming user, some, all, and for the remaining part of the ring. */
const [NOBODY, SOME, ALL, REST] = ['#e6ebf2', '#ffb52e', '#35d07f', '#3a434e'].map((name) => new Color(name));
const PIECES = 96;

export interface Ball {
  readonly meshes: readonly Drawn[];
  /**
   * Sets the world position, the radius, the share of users who aim at it, and the elapsed share of the holding time.
   */
  show(at: Vector | null, radius: number, share: number, held: number): void;
  /** Places it for pictures whose centre is at the origin. */
  place(center: Point): void;
}

export function createBall(shared: Shared): Ball {
  const color = new Vector4(1, 1, 1, 1);
  const size = { value: 1 };
  const body = createMesh(new SphereGeometry(1, 40, 28), shared, NEAR_VERTEX, { SMOOTH: '' }, {
    base_color: { value: color },
    placement: { value: new Matrix4() },
  });
  const ring = (base: Color | undefined): Drawn =>
    createMesh(turn(), shared, RING_VERTEX, { UNLIT: '' }, {
      base_color: { value: new Vector4(base?.r, base?.g, base?.b, 1) },
      begin: { value: new Vector3() },
      radius: size,
      shares: { value: [0, 1] },
    });
  const [done, rest] = [ring(ALL), ring(REST)];
  let meshes: readonly Drawn[] = [];
  let middle: Vector = [0, 0, 0];

  return {
    get meshes() {
      return meshes;
    },
    show(at, radius, share, held) {
      meshes = at ? [body, done, rest] : [];
      if (!at) return;
      middle = at;
      size.value = radius;
      const { r, g, b } = (share >= 1 ? ALL : share > 0 ? SOME : NOBODY) ?? new Color();
      color.set(r, g, b, 1);
      set(done, 'shares', [0, held]);
      set(rest, 'shares', [held, 1]);
    },
    place(center) {
      const [x, y, z] = minus(middle, center);
      const { value: radius } = size;
      (body.material.uniforms['placement']?.value as Matrix4).makeScale(radius, radius, radius).setPosition(x, y, z);
      for (const { material } of [done, rest]) (material.uniforms['begin']?.value as Vector3).set(x, y, z);
    },
  };
}

function set({ material }: Drawn, name: string, value: unknown): void {
  const uniform = material.uniforms[name];
  if (uniform) uniform.value = value;
}

/** Strip of a full turn: x is the share of the turn; y is 0 inside, 1 outside. */
function turn(): BufferGeometry {
  const [places, corners]: [number[], number[]] = [[], []];
  for (let piece = 0; piece <= PIECES; piece++) {
    places.push(piece / PIECES, 0, 0, piece / PIECES, 1, 0);
    const first = 2 * piece;
    if (piece < PIECES) corners.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
  }
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(new Float32Array(places), 3));
  made.setIndex(corners);
  return made;
}
