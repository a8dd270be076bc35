/** Region on the GPU: the geometry of all rings, and the maps of two rings. */
import { Group, type Texture, type WebGLRenderer } from 'three';
import type { RegionEntry } from '../bundle/manifest';
import type { Part, Piece, Triangles } from '../decode/messages';
import type { Store } from './buffers';
import { createMaterials, type Shared, texturesOf } from './materials';
import { disposeMesh, type MeshResources, type PieceMesh, preparePiece, type PreparedPiece } from './pieces';
import { createCube, type Cube, type Pictures } from './textures';

/** Meshes per step: three.js takes about 0.1 ms to begin a picture, and 0.05 ms for each mesh. */
const MESHES_PER_STEP = 4;

export type Region = ReturnType<typeof createRegion>;

/** Creates an empty region; the faces of its maps have `size` texels along an edge. */
export function createRegion(renderer: WebGLRenderer, entry: RegionEntry, size: number, store: Store, shared: Shared) {
  /** Meshes of each ring, invisible until the ring is complete. The group of ring 0 has the dynamic objects. */
  const groups = entry.rings.map(() => Object.assign(new Group(), { visible: false }));
  const materials = createMaterials(shared);
  const make = (): Cube => createCube(renderer, size, entry.range);
  /** Cubes that rings use in turn: one has the visible map, the next map is loaded into the other one. */
  const cubes: [Cube, Cube] = [make(), make()];
  return {
    entry,
    groups,
    materials,
    /** Triangles of each ring; 0 until the ring is complete. */
    triangles: entry.rings.map((): Triangles => ({ inFile: 0, drawn: 0 })),
    cubes,
    dispose(): void {
      for (const group of groups) {
        for (const mesh of meshesOf(group)) disposeMesh(mesh, store);
        group.clear();
      }
      materials.dispose();
      for (const cube of cubes) cube.dispose();
    },
  };
}

/** Returns the cube that has the map of a ring. */
export function cubeOf(region: Region, ring: number): Cube {
  const cubeOfRing = region.cubes.find((cube) => cube.ringShown === ring);
  if (!cubeOfRing) throw new Error(`the map of ring ${ring} is missing`);
  return cubeOfRing;
}

export function hasMap({ entry }: Region, ring: number): boolean {
  const { map, sharper } = entry.rings[ring] ?? {};
  return Boolean(map ?? sharper);
}

/** Returns the index of the cube that takes a ring's map. */
export function cubeIndexOf(ring: number): 0 | 1 {
  return ring % 2 === 0 ? 0 : 1;
}

export function meshesOf(group: Group): PieceMesh[] {
  return group.children as PieceMesh[];
}

/** Shows the geometry of a ring, or the dynamic objects for ring 0, and records its triangles. */
export function showRing(region: Region, ring: number, triangles: Triangles): void {
  (region.groups[ring] as Group).visible = true;
  region.triangles[ring] = triangles;
}

/** Returns the number of triangles in a picture with all rings up to `ring`. */
export function countTriangles(region: Region, ring: number): Triangles {
  return region.triangles.slice(0, ring + 1).reduce((sum, { inFile, drawn }) => {
    return { inFile: sum.inFile + inFile, drawn: sum.drawn + drawn };
  }, { inFile: 0, drawn: 0 });
}

/** Steps that upload a part of a file's geometry and add it to the group of its ring. */
export function* partSteps(region: Region, ring: number, part: Part, resources: MeshResources, pictures: Pictures) {
  const { bands, pieces } = part;
  // Dynamic objects, which are in ring 0, are also drawn beyond the cut.
  const cut = ring === 0 ? Infinity : region.entry.cut;
  const group = region.groups[ring] as Group;
  const { copy, store } = resources;
  const find = (uri: string, isSecondUse: boolean): Texture | null =>
    isSecondUse ? store.copyOf(uri, copy) : (store.textures.get(uri) ?? null);
  const uploaded: { piece: Piece; prepared: PreparedPiece }[] = [];
  const addMeshes = (): void => {
    const meshes = uploaded.splice(0).map(({ piece, prepared }) => {
      const textures = texturesOf(piece.material, find);
      return prepared.make(region.materials.get(piece, textures, cut));
    });
    resources.warmUp(meshes);
    group.add(...meshes);
  };
  try {
    for (const band of bands) yield* pictures.steps(band);
    for (const [number, piece] of pieces.entries()) {
      const prepared = preparePiece(piece, resources);
      uploaded.push({ piece, prepared });
      yield* prepared.steps();
      const isLast = number === pieces.length - 1;
      if (uploaded.length === MESHES_PER_STEP || isLast) yield { kind: 'mesh', bytes: 0, run: addMeshes } as const;
    }
  } finally {
    for (const { prepared } of uploaded) prepared.free();
    for (const { bitmap } of bands) bitmap.close();
  }
}
