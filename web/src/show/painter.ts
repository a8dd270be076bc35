/** Draws pictures: morphed near geometry, the map in all other pixels, and a dark veil while the user jumps. */
import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  CustomBlending,
  GLSL3,
  type Material,
  Mesh,
  type Object3D,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RawShaderMaterial,
  Scene,
  type WebGLRenderer,
} from 'three';
import type { Point } from '../bundle/manifest';
import { farMaterial, type Shared } from './materials';
import { cubeOf, hasMap, meshesOf, type Region } from './region';
import type { Cube } from './textures';

/** Content of a picture. */
export interface Picture {
  readonly region: Region;
  /** Last ring whose geometry is drawn; its map shows everything beyond. */
  readonly ring: number;
  /** R, metres. */
  readonly radius: number;
  /** Strength of the morph, 0 to 1; null for the conventional picture, whose geometry is not morphed. */
  readonly strength: number | null;
}

/** Other users, drawn like dynamic objects: morphed, and hidden where the map is nearer. */
export interface Guests {
  readonly meshes: readonly (Mesh & { readonly material: Material })[];
  /** Updates their positions for pictures with this centre at the origin. */
  place(center: Point): void;
}

/** Parts of a picture that are not drawn. */
type OmittedParts = Readonly<Partial<Record<'map' | 'guests', boolean>>>;

export type Painter = ReturnType<typeof createPainter>;

/**
 * Creates a painter for a renderer. `blank` returns an empty map, for regions without maps. `place` moves the camera so
 * that the centre of a region is at the origin.
 */
export function createPainter(
  renderer: WebGLRenderer,
  shared: Shared,
  nearShare: number,
  blank: () => Cube,
  place: (center: Point) => void,
) {
  const near = new Scene();
  const far = new Scene().add(screenMesh(farMaterial(shared)));
  let guests: Guests | null = null;

  return {
    /** Compiles the shaders of the first picture while its files are loaded. */
    prepare(camera: Camera): void {
      renderer.compile(far, camera);
    },
    /** Draws a picture, with an opacity, over what is already drawn. */
    draw({ region, ring, radius, strength }: Picture, camera: Camera, opacity: number, omitted: OmittedParts = {}): void {
      place(region.entry.center);
      const cube = hasMap(region, ring) ? cubeOf(region, ring) : blank();
      const inner = nearShare * radius;
      // With R = 0 the weight of the user's view is 0 everywhere: all points appear as seen from the centre.
      const slope = radius > 0 ? 1 / (radius - inner) : 1;
      shared.radii.value.set(inner, radius, slope, strength ?? -1);
      [shared.map.value, shared.codes.value] = [cube.color, cube.codes];
      shared.coding.value.set(cube.scale.least, cube.scale.step, cube.size, cube.hasRange ? 1 : 0);
      shared.opacity.value = opacity;
      const guestMeshes = omitted.guests ? [] : (guests?.meshes ?? []);
      if (guestMeshes.length > 0) guests?.place(region.entry.center);
      const groups = region.groups.slice(0, ring + 1);
      const fadingMeshes = opacity < 1 ? [...groups.flatMap(meshesOf), ...guestMeshes] : [];
      near.children = [...groups, ...guestMeshes] as Object3D[];
      renderer.clearDepth();
      if (opacity < 1) {
        // Depths are drawn first; otherwise hidden surfaces would shine through.
        setWrites(fadingMeshes, false, true);
        renderer.render(near, camera);
        setWrites(fadingMeshes, true, false);
      }
      renderer.render(near, camera);
      if (opacity < 1) setWrites(fadingMeshes, true, true);
      if (!omitted.map) renderer.render(far, camera);
      near.children = [];
    },
    /** Sets the other users to draw; null for none. */
    setGuests(next: Guests | null): void {
      guests = next;
    },
  };
}

function setWrites(meshes: Guests['meshes'], color: boolean, depth: boolean): void {
  for (const { material } of meshes) {
    material.colorWrite = color;
    material.depthWrite = depth;
  }
}

/** Vertex shader of a triangle that covers the whole picture. */
export const SCREEN_VERTEX = /* glsl */ `
in vec3 position;

void main() {
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision mediump float;
uniform float darkness;
out vec4 shade;

void main() {
  shade = vec4(0.0, 0.0, 0.0, darkness);
}
`;

/** Creates a black surface in front of the whole picture, invisible at first. */
export function createVeil() {
  const darkness = { value: 0 };
  const material = new RawShaderMaterial({
    vertexShader: SCREEN_VERTEX,
    fragmentShader: FRAGMENT,
    glslVersion: GLSL3,
    uniforms: { darkness },
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    depthTest: false,
    depthWrite: false,
    transparent: true,
  });
  const mesh = screenMesh(material);
  mesh.visible = false;
  return {
    mesh,
    /** Sets the darkness: 0 for none, 1 for black. */
    set(value: number): void {
      darkness.value = value;
      mesh.visible = value > 0;
    },
  };
}

/** Creates a triangle that covers the whole picture. */
export function screenMesh(material: Material): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
  return Object.assign(new Mesh(geometry, material), { frustumCulled: false });
}
