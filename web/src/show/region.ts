/** A region on the GPU: the geometry of its rings, and the maps of the last two of them. */
import { Group, type WebGLRenderer } from 'three';
import type { RegionEntry } from '../bundle/manifest';
import type { Geometry } from '../decode/messages';
import { type Cube, createCube } from './cubes';
import type { Shared } from './materials';
import { disposeMesh, meshOf, type PieceMesh, textureOf } from './pieces';
import type { Store } from './store';
import type { Step } from './uploads';

export interface Region {
  readonly entry: RegionEntry;
  /** Groups by ring; that of ring 0 has the dynamic objects, which every picture shows. */
  readonly groups: readonly Group[];
  /** Two cubes in turn: the one of the ring that is shown, and the one that is being made. */
  readonly cubes: readonly [Cube, Cube];
  dispose(): void;
}

export function createRegion(
  renderer: WebGLRenderer,
  entry: RegionEntry,
  faceSize: number,
  store: Store,
): Region {
  const groups = entry.rings.map(() => new Group());
  const cubes = [createCube(renderer, faceSize), createCube(renderer, faceSize)] as const;
  return {
    entry,
    groups,
    cubes,
    dispose() {
      for (const group of groups) {
        for (const mesh of meshesOf(group)) disposeMesh(mesh, store);
        group.clear();
      }
      for (const cube of cubes) cube.dispose();
    },
  };
}

/** The cube that holds a ring's map. */
export function cubeOf(region: Region, ring: number): Cube {
  const found = region.cubes.find((cube) => cube.holds === ring);
  if (!found) throw new Error(`the map of ring ${ring} is not there`);
  return found;
}

export function meshesOf(group: Group): PieceMesh[] {
  return group.children as PieceMesh[];
}

/** Triangles drawn in a picture with all rings up to one. */
export function trianglesShown(region: Region, ring: number): number {
  return region.groups
    .slice(0, ring + 1)
    .flatMap(meshesOf)
    .reduce((sum, mesh) => sum + (mesh.userData['triangles'] as number), 0);
}

/**
 * Steps after which geometry is on the GPU and in the group of its ring; if they end before, nothing is left of it.
 * `warm` makes three.js upload a mesh.
 */
export function* geometrySteps(
  renderer: WebGLRenderer,
  region: Region,
  ring: number,
  geometry: Geometry,
  shared: Shared,
  store: Store,
  warm: (mesh: PieceMesh) => void,
): Generator<Step> {
  // Dynamic objects, in ring 0, go on beyond it.
  const cut = ring === 0 ? Infinity : region.entry.cut;
  const group = region.groups[ring];
  if (!group) throw new Error(`there is no ring ${ring}`);
  const made: PieceMesh[] = [];
  try {
    for (const [uri, image] of Object.entries(geometry.images)) {
      yield () => {
        // Another region may have brought it meanwhile.
        if (store.textures.has(uri)) return;
        const texture = textureOf(image);
        renderer.initTexture(texture);
        store.textures.set(uri, texture);
      };
    }
    for (const piece of geometry.pieces) {
      yield () => {
        const { image } = piece.material;
        const texture = image === null ? null : (store.textures.get(image) ?? null);
        const mesh = meshOf(piece, texture, shared, store, cut);
        made.push(mesh);
        warm(mesh);
      };
    }
    // Together, so that no frame shows a part of a ring.
    yield () => {
      group.add(...made.splice(0));
    };
  } finally {
    for (const image of Object.values(geometry.images)) image.close();
    for (const mesh of made) disposeMesh(mesh, store);
  }
}
