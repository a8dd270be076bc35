/** Drawing of a pointer. */
import { Vector3, type Vector4 } from 'three';
import type { Point } from '../bundle/manifest';
import { minus, type Vector } from '../control/vector';
import type { Shared } from '../show/materials';
import { type Drawn, createMesh, setPoint } from './drawn';
import type { Body } from './pose';
import { rotated } from './rotation';
import { POINTER_VERTEX } from './shaders';
import type { Shapes } from './shapes';

export interface Ray {
  readonly mesh: Drawn;
  /** Places the pointer of a body, if it has one, for pictures with this centre at the origin. */
  place(body: Body, center: Point): void;
}

export function createRay(shapes: Shapes, shared: Shared, color: Vector4): Ray {
  const mesh = createMesh(shapes.pointer, shared, POINTER_VERTEX, { UNLIT: '' }, {
    base_color: { value: color },
    begin: { value: new Vector3() },
    end: { value: new Vector3() },
  });
  return {
    mesh,
    place(body, center) {
      const ends = endsOf(body);
      if (!ends) return;
      setPoint(mesh, 'begin', minus(ends.begin, center));
      setPoint(mesh, 'end', minus(ends.end, center));
    },
  };
}

/** Both ends of a pointer in world space; null without a pointer. */
function endsOf({ head, left, right, pointer }: Body): { readonly begin: Vector; readonly end: Vector } | null {
  const from = pointer && { head, left, right }[pointer.begin];
  if (!from) return null;
  const [x, y, z] = from.position;
  const [dx, dy, dz] = rotated(from.rotation, [0, 0, -pointer.length]);
  return { begin: from.position, end: [x + dx, y + dy, z + dz] };
}
