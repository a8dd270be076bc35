/** Draws pictures: near geometry where the morph shows it, and the map wherever nothing near is. */
import { type Camera, Mesh, type Object3D, Scene, type WebGLRenderer } from 'three';
import type { Point } from '../bundle/manifest';
import type { Cube } from './cubes';
import { farMaterial, type Shared } from './materials';
import { cubeOf, hasMap, meshesOf, type Region } from './region';
import { covering } from './veil';

/** The state that a picture shows. */
export interface Picture {
  readonly region: Region;
  /** Last ring whose geometry is shown; its map shows what lies beyond. */
  readonly ring: number;
  /** R, metres. */
  readonly radius: number;
  /** 0 to 1; null for the conventional picture: near geometry in its place, and the map as the centre sees it. */
  readonly strength: number | null;
}

export interface Painter {
  /** Let the GPU make ready what the first picture needs, while its files come. */
  prepare(camera: Camera): void;
  /** Draw a picture over what is there, as a share of it; 1 hides what was there. The map can be shown elsewhere. */
  draw(picture: Picture, camera: Camera, opacity: number, withMap?: boolean): void;
}

/**
 * A painter for one renderer. `blank` gives a map that shows nothing, for pictures without one. `place` moves the rig of the camera, so that the centre of a region is at the origin.
 */
export function createPainter(
  renderer: WebGLRenderer,
  shared: Shared,
  nearShare: number,
  blank: () => Cube,
  place: (center: Point) => void,
): Painter {
  const near = new Scene();
  const far = new Scene();
  far.add(screen(shared));

  return {
    prepare(camera) {
      renderer.compile(far, camera);
    },
    draw(picture, camera, opacity, withMap = true) {
      const { region, ring, radius, strength } = picture;
      place(region.entry.center);
      const cube = hasMap(region, ring) ? cubeOf(region, ring) : blank();
      const inner = nearShare * radius;
      // With R = 0 everything is shown as the centre sees it: the weight of the user's view is 0 at any distance.
      const slope = radius > 0 ? 1 / (radius - inner) : 1;
      shared.radii.value.set(inner, radius, slope, strength ?? -1);
      shared.map.value = cube.color;
      shared.codes.value = cube.codes;
      const { least, step } = cube.scale;
      shared.coding.value.set(least, step, cube.size, cube.hasRange ? 1 : 0);
      shared.opacity.value = opacity;
      near.children = region.groups.slice(0, ring + 1) as Object3D[];
      renderer.clearDepth();
      if (opacity < 1) {
        // Depth alone first: else a surface behind another one would shine through it.
        setWrites(region, ring, false, true);
        renderer.render(near, camera);
        setWrites(region, ring, true, false);
      }
      renderer.render(near, camera);
      if (opacity < 1) setWrites(region, ring, true, true);
      if (withMap) renderer.render(far, camera);
      near.children = [];
    },
  };
}

function setWrites(region: Region, ring: number, color: boolean, depth: boolean): void {
  for (const mesh of region.groups.slice(0, ring + 1).flatMap(meshesOf)) {
    mesh.material.colorWrite = color;
    mesh.material.depthWrite = depth;
  }
}

/** One triangle over the whole picture. */
function screen(shared: Shared): Mesh {
  const mesh = new Mesh(covering(), farMaterial(shared));
  mesh.frustumCulled = false;
  return mesh;
}
