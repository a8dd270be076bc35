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
import { subtract } from '../control/pose';
import { NEAR_FRAGMENT } from '../shaders/scene';
import { BLENDING, NO_CUT, type Shared } from '../show/materials';
import { type Body, rotate } from './pose';
import { POINTER_VERTEX } from './shaders';

export type DrawnMesh = Mesh<BufferGeometry, RawShaderMaterial>;

/** Creates a mesh that its vertex shader places. */
export function createMesh(
  shape: BufferGeometry,
  shared: Shared,
  vertexShader: string,
  defines: Record<string, string>,
  uniforms: Record<string, IUniform>,
): DrawnMesh {
  const material = new RawShaderMaterial({
    ...BLENDING,
    vertexShader,
    fragmentShader: NEAR_FRAGMENT,
    defines,
    uniforms: { ...shared, ...uniforms, cut: { value: NO_CUT } },
  });
  const mesh = new Mesh(shape, material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

/** Sets a uniform's colour to that of a user. */
export function setUserColor(color: Vector4, number: number): void {
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

/** Number of pieces of a pointer's ribbon; they are shorter than a metre if the pointer has 100 m. */
const RIBBON_PIECES = 160;
/** Number of vertices around the spot at the pointer's end. */
const SPOT_CORNERS = 20;
/** Radii of a head along its axes, metres. */
const [HEAD_X, HEAD_Y, HEAD_Z] = [0.085, 0.13, 0.105] as const;
/** Metres from the eyes back to the centre of the head. */
const EYE_TO_CENTER = 0.06;

export type Shapes = ReturnType<typeof createShapes>;

export function createShapes() {
  return {
    head: new SphereGeometry(1, 24, 16).scale(HEAD_X, HEAD_Y, HEAD_Z).translate(0, 0, EYE_TO_CENTER),
    /** Visor in front of the eyes, which shows their direction. */
    visor: new BoxGeometry(2 * HEAD_X, 0.07, 0.07).translate(0, 0, EYE_TO_CENTER - HEAD_Z + 0.02),
    hand: new CapsuleGeometry(0.025, 0.1, 4, 12).rotateX(Math.PI / 2).translate(0, 0, 0.05),
    pointer: createPointerShape(),
    name: new PlaneGeometry(1, 1).translate(0, 0.5, 0),
  };
}

/** Ribbon along the pointer, and a disc at its end, whose vertices have x = 2. */
function createPointerShape(): BufferGeometry {
  const ribbon = createRibbon(RIBBON_PIECES, -1);
  const positions = [...ribbon.getAttribute('position').array];
  const indices = [...(ribbon.index?.array ?? [])];
  const middle = positions.length / 3;
  positions.push(2, 0, 0);
  for (let corner = 0; corner < SPOT_CORNERS; corner++) {
    const angle = (2 * Math.PI * corner) / SPOT_CORNERS;
    positions.push(2, Math.cos(angle), Math.sin(angle));
    indices.push(middle, middle + 1 + corner, middle + 1 + ((corner + 1) % SPOT_CORNERS));
  }
  const attribute = new BufferAttribute(new Float32Array(positions), 3);
  return new BufferGeometry().setAttribute('position', attribute).setIndex(indices);
}

/** Ribbon of pieces: x is the share of the length; y is `low` on one side and 1 on the other. */
export function createRibbon(pieces: number, low: number): BufferGeometry {
  return new PlaneGeometry(1, 1 - low, pieces, 1).scale(1, -1, 1).translate(0.5, (1 + low) / 2, 0);
}

export function createRay(shapes: Shapes, shared: Shared, color: Vector4) {
  const [begin, end] = [new Vector3(), new Vector3()];
  const uniforms = { base_color: { value: color }, begin: { value: begin }, end: { value: end } };
  const mesh = createMesh(shapes.pointer, shared, POINTER_VERTEX, { UNLIT: '' }, uniforms);
  return {
    mesh,
    /** Places the pointer of a body, if it has one, for pictures that have this centre at the origin. */
    place({ head, left, right, pointer }: Body, center: Point): void {
      const origin = pointer && { head, left, right }[pointer.begin];
      if (!origin) return;
      begin.set(...subtract(origin.position, center));
      end.set(...rotate(origin.rotation, [0, 0, -pointer.length])).add(begin);
    },
  };
}
