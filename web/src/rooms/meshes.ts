/** Meshes of avatars and pointers: their shapes, colours and materials. */
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  Color,
  type IUniform,
  Mesh,
  PlaneGeometry,
  RawShaderMaterial,
  SphereGeometry,
  Vector3,
  type Vector4,
} from 'three';
import type { Point } from '../bundle/manifest';
import { subtract, type Vector } from '../control/pose';
import { NEAR_FRAGMENT } from '../shaders/scene';
import { BLENDING, NOWHERE, type Shared } from '../show/materials';
import { type Body, rotate } from './pose';
import { POINTER_VERTEX } from './shaders';

export type Drawn = Mesh<BufferGeometry, RawShaderMaterial>;

/** Creates a mesh that its vertex shader places. */
export function createMesh(
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

/** Sets a colour for uniforms to that of a user. */
export function paint(color: Vector4, number: number): void {
  const { r, g, b } = colorOf(number);
  color.set(r, g, b, 1);
}

/** Step of hue from one number to the next, in turns: the golden ratio. */
const HUE_STEP = 0.618034;
const [SATURATION, LIGHTNESS] = [0.75, 0.6] as const;

export function colorOf(number: number): Color {
  return new Color().setHSL((number * HUE_STEP) % 1, SATURATION, LIGHTNESS);
}

/** Colour of a user for style sheets. */
export function cssOf(number: number): string {
  return `#${colorOf(number).getHexString()}`;
}

/** Number of pieces of a pointer's ribbon: at a length of 100 m each is shorter than a metre. */
const RIBBON_PIECES = 160;
/** Number of vertices around its spot. */
const SPOT_CORNERS = 20;
/** Radii of a head along its axes, metres. */
const [HEAD_X, HEAD_Y, HEAD_Z] = [0.085, 0.13, 0.105] as const;
/** Metres from the eyes back to the centre of the head. */
const EYE_TO_CENTER = 0.06;

export interface Shapes {
  readonly head: BufferGeometry;
  /** Visor in front of the eyes, which shows their direction. */
  readonly visor: BufferGeometry;
  readonly hand: BufferGeometry;
  readonly pointer: BufferGeometry;
  readonly name: BufferGeometry;
}

export function createShapes(): Shapes {
  return {
    head: new SphereGeometry(1, 24, 16).scale(HEAD_X, HEAD_Y, HEAD_Z).translate(0, 0, EYE_TO_CENTER),
    visor: new BoxGeometry(2 * HEAD_X, 0.07, 0.07).translate(0, 0, EYE_TO_CENTER - HEAD_Z + 0.02),
    hand: new CapsuleGeometry(0.025, 0.1, 4, 12).rotateX(Math.PI / 2).translate(0, 0, 0.05),
    pointer: pointer(),
    name: new PlaneGeometry(1, 1).translate(0, 0.5, 0),
  };
}

function pointer(): BufferGeometry {
  const { places, corners } = ribbon(RIBBON_PIECES, -1);
  const middle = places.length / 3;
  places.push(2, 0, 0);
  for (let corner = 0; corner < SPOT_CORNERS; corner++) {
    const angle = (2 * Math.PI * corner) / SPOT_CORNERS;
    places.push(2, Math.cos(angle), Math.sin(angle));
    corners.push(middle, middle + 1 + corner, middle + 1 + ((corner + 1) % SPOT_CORNERS));
  }
  return geometryOf({ places, corners });
}

/** Vertices, three numbers each, and the corners of triangles. */
export interface Triangles {
  readonly places: number[];
  readonly corners: number[];
}

/** Ribbon in pieces: x is the share of its length; y is `low` on one side and 1 on the other. */
export function ribbon(pieces: number, low: number): Triangles {
  const [places, corners]: [number[], number[]] = [[], []];
  for (let piece = 0; piece <= pieces; piece++) {
    places.push(piece / pieces, low, 0, piece / pieces, 1, 0);
    const first = 2 * piece;
    if (piece < pieces) corners.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
  }
  return { places, corners };
}

export function geometryOf({ places, corners }: Triangles): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(places), 3));
  geometry.setIndex(corners);
  return geometry;
}

export function createRay(shapes: Shapes, shared: Shared, color: Vector4) {
  const [begin, end] = [new Vector3(), new Vector3()];
  const uniforms = { base_color: { value: color }, begin: { value: begin }, end: { value: end } };
  const mesh = createMesh(shapes.pointer, shared, POINTER_VERTEX, { UNLIT: '' }, uniforms);
  return {
    mesh,
    /** Places the pointer of a body, if it has one, for pictures with this centre at the origin. */
    place(body: Body, center: Point): void {
      const ends = endsOf(body);
      if (!ends) return;
      begin.set(...subtract(ends.begin, center));
      end.set(...subtract(ends.end, center));
    },
  };
}

/** Both ends of a pointer in world space; null without a pointer. */
function endsOf({ head, left, right, pointer }: Body): { readonly begin: Vector; readonly end: Vector } | null {
  const from = pointer && { head, left, right }[pointer.begin];
  if (!from) return null;
  const [x, y, z] = from.position;
  const [dx, dy, dz] = rotate(from.rotation, [0, 0, -pointer.length]);
  return { begin: from.position, end: [x + dx, y + dy, z + dz] };
}
