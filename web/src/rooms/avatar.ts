/** Drawing of a user: a head with a name above it, hands, and a pointer. */
import { type BufferGeometry, Matrix4, Quaternion, type Texture, Vector3, Vector4 } from 'three';
import type { Point } from '../bundle/manifest';
import { minus } from '../control/vector';
import { NEAR_VERTEX } from '../shaders/near';
import type { Shared } from '../show/materials';
import { colorOf } from './color';
import { type Drawn, createMesh, paint, setPoint } from './drawn';
import { createLabel } from './label';
import type { Body, Placed } from './pose';
import { createRay } from './ray';
import { NAME_VERTEX } from './shaders';
import type { Shapes } from './shapes';

/** Metres from the eyes up to the name. */
const ABOVE = 0.2;
const VISOR = new Vector4(0.03, 0.035, 0.045, 1);

export interface Avatar {
  /** Meshes of the visible parts of the body. */
  readonly meshes: readonly Drawn[];
  /** Assigns the avatar to a user. */
  be(number: number, name: string): void;
  /** Sets the body in world space. */
  show(body: Body): void;
  /** Updates positions for pictures with this centre at the origin. */
  place(center: Point): void;
  dispose(): void;
}

/** Creates an avatar without a user. */
export function createAvatar(shapes: Shapes, shared: Shared): Avatar {
  const own = new Vector4();
  const solid = (shape: BufferGeometry, base: Vector4): Drawn => {
    const uniforms = { base_color: { value: base }, placement: { value: new Matrix4() } };
    return createMesh(shape, shared, NEAR_VERTEX, { SMOOTH: '' }, uniforms);
  };
  const parts = {
    head: solid(shapes.head, own),
    visor: solid(shapes.visor, VISOR),
    left: solid(shapes.hand, own),
    right: solid(shapes.hand, own),
  };
  const ray = createRay(shapes, shared, own);
  const [image, ratio] = [{ value: null as Texture | null }, { value: 1 }];
  const title = createMesh(shapes.name, shared, NAME_VERTEX, { TEXTURED: '', CUTOUT: '', UNLIT: '' }, {
    base_color: { value: new Vector4(1, 1, 1, 1) },
    image,
    cutoff: { value: 0.5 },
    begin: { value: new Vector3() },
    ratio,
  });
  let body: Body | null = null;

  return {
    get meshes() {
      return [
        parts.head,
        parts.visor,
        title,
        ...(body?.left ? [parts.left] : []),
        ...(body?.right ? [parts.right] : []),
        ...(body?.pointer ? [ray.mesh] : []),
      ];
    },
    be(number, name) {
      image.value?.dispose();
      const label = createLabel(name, colorOf(number));
      [image.value, ratio.value] = [label.texture, label.ratio];
      paint(own, number);
    },
    show(next) {
      body = next;
    },
    place(center) {
      if (!body) return;
      const { head, left, right } = body;
      const [x, y, z] = minus(head.position, center);
      for (const [part, placed] of [['head', head], ['visor', head], ['left', left], ['right', right]] as const) {
        if (placed) compose(parts[part], placed, center);
      }
      setPoint(title, 'begin', [x, y + ABOVE, z]);
      ray.place(body, center);
    },
    dispose() {
      image.value?.dispose();
      for (const { material } of [...Object.values(parts), ray.mesh, title]) material.dispose();
    },
  };
}

function compose({ material }: Drawn, { position, rotation }: Placed, center: Point): void {
  const matrix = material.uniforms['placement']?.value as Matrix4;
  const place = new Vector3(...minus(position, center));
  matrix.compose(place, new Quaternion(...rotation).normalize(), new Vector3(1, 1, 1));
}
