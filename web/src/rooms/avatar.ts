/** The drawing of a user: a head with a name above it, hands, and a pointer. */
import {
  type BufferGeometry,
  type IUniform,
  Matrix4,
  Mesh,
  Quaternion,
  RawShaderMaterial,
  Vector3,
  Vector4,
} from 'three';
import type { Point } from '../bundle/manifest';
import { minus, type Vector } from '../control/vector';
import { NEAR_FRAGMENT, NEAR_VERTEX } from '../shaders/near';
import { BLENDING, NOWHERE, type Shared } from '../show/materials';
import { colorOf } from './color';
import { createLabel } from './label';
import type { Body, Placed } from './pose';
import { rotated } from './rotation';
import { NAME_VERTEX, POINTER_VERTEX } from './shaders';
import type { Shapes } from './shapes';

/** Metres from the eyes up to the name. */
const ABOVE = 0.2;
const VISOR = new Vector4(0.03, 0.035, 0.045, 1);

export type Drawn = Mesh<BufferGeometry, RawShaderMaterial>;

export interface Avatar {
  /** Those that are seen now. */
  readonly meshes: readonly Drawn[];
  /** A body in the world, and whether head and hands are drawn, too. */
  show(body: Body, isWhole: boolean): void;
  /** Put it for pictures whose centre is at the origin. */
  place(center: Point): void;
  dispose(): void;
}

export function createAvatar(number: number, name: string, shapes: Shapes, shared: Shared): Avatar {
  const color = colorOf(number);
  const own = new Vector4(color.r, color.g, color.b, 1);
  const label = createLabel(name, color);
  const solid = (shape: BufferGeometry, base: Vector4): Drawn => {
    const uniforms = { base_color: { value: base }, placement: { value: new Matrix4() } };
    return drawn(shape, shared, NEAR_VERTEX, { SMOOTH: '' }, uniforms);
  };
  const parts = {
    head: solid(shapes.head, own),
    visor: solid(shapes.visor, VISOR),
    left: solid(shapes.hand, own),
    right: solid(shapes.hand, own),
  };
  const pointer = drawn(shapes.pointer, shared, POINTER_VERTEX, { UNLIT: '' }, {
    base_color: { value: own },
    begin: { value: new Vector3() },
    end: { value: new Vector3() },
  });
  const title = drawn(shapes.name, shared, NAME_VERTEX, { TEXTURED: '', CUTOUT: '', UNLIT: '' }, {
    base_color: { value: new Vector4(1, 1, 1, 1) },
    image: { value: label.texture },
    cutoff: { value: 0.5 },
    begin: { value: new Vector3() },
    ratio: { value: label.ratio },
  });
  let body: Body | null = null;
  let meshes: readonly Drawn[] = [];

  return {
    get meshes() {
      return meshes;
    },
    show(next, isWhole) {
      body = next;
      meshes = [
        ...(isWhole ? [parts.head, parts.visor, title] : []),
        ...(isWhole && next.left ? [parts.left] : []),
        ...(isWhole && next.right ? [parts.right] : []),
        ...(next.pointer ? [pointer] : []),
      ];
    },
    place(center) {
      if (!body) return;
      const { head, left, right } = body;
      const [x, y, z] = minus(head.position, center);
      for (const [part, placed] of [['head', head], ['visor', head], ['left', left], ['right', right]] as const) {
        if (placed) compose(parts[part], placed, center);
      }
      set(title, 'begin', [x, y + ABOVE, z]);
      const ray = rayOf(body);
      if (!ray) return;
      set(pointer, 'begin', minus(ray.begin, center));
      set(pointer, 'end', minus(ray.end, center));
    },
    dispose() {
      label.texture.dispose();
      for (const { material } of [...Object.values(parts), pointer, title]) material.dispose();
    },
  };
}

/** Both ends of a pointer in the world; null without one. */
export function rayOf({ head, left, right, pointer }: Body): { readonly begin: Vector; readonly end: Vector } | null {
  const from = pointer && { head, left, right }[pointer.begin];
  if (!from) return null;
  const [x, y, z] = from.position;
  const [dx, dy, dz] = rotated(from.rotation, [0, 0, -pointer.length]);
  return { begin: from.position, end: [x + dx, y + dy, z + dz] };
}

/** A mesh of near geometry's shading, with uniforms of its own beside those of the picture. */
export function drawn(
  shape: BufferGeometry,
  shared: Shared,
  vertexShader: string,
  defines: Record<string, string>,
  own: Record<string, IUniform>,
): Drawn {
  const material = new RawShaderMaterial({
    ...BLENDING,
    vertexShader,
    fragmentShader: NEAR_FRAGMENT,
    defines,
    uniforms: { ...shared, ...own, cut: { value: NOWHERE } },
  });
  const mesh = new Mesh(shape, material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

function compose({ material }: Drawn, { position, rotation }: Placed, center: Point): void {
  const matrix = material.uniforms['placement']?.value as Matrix4;
  const place = new Vector3(...minus(position, center));
  matrix.compose(place, new Quaternion(...rotation).normalize(), new Vector3(1, 1, 1));
}

function set({ material }: Drawn, name: string, value: Vector): void {
  (material.uniforms[name]?.value as Vector3).set(...value);
}
