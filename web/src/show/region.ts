/** Region on the GPU: the geometry of its rings, and the maps of the last two of them. */
import { Group, type WebGLRenderer } from 'three';
import type { RegionEntry } from '../bundle/manifest';
import type { Part, Piece, Triangles } from '../decode/messages';
import type { Store } from './buffers';
import { createMaterials, type Shared, texturesOf } from './materials';
import { disposeMesh, type MeshResources, type PieceMesh, prepare, type Prepared } from './pieces';
import { createCube, type Cube, type Pictures } from './textures';

/** Meshes per step: three.js takes about 0.1 ms to begin a picture, and half as long for each mesh. */
const MESHES_PER_STEP = 4;

export type Region = ReturnType<typeof createRegion>;

/** Creates a region without content; the faces of its maps have `size` texels along an edge. */
export function createRegion(renderer: WebGLRenderer, entry: RegionEntry, size: number, store: Store, shared: Shared) {
  /** Groups by ring, invisible until complete; the group of ring 0 has the dynamic objects of all pictures. */
  const groups = entry.rings.map(() => Object.assign(new Group(), { visible: false }));
  const materials = createMaterials(shared);
  const make = (): Cube => createCube(renderer, size, entry.range);
  /** Two cubes in alternation: that of the visible ring, and that of the ring being loaded. */
  const cubes: [Cube, Cube] = [make(), make()];
  return {
    entry,
    groups,
    materials,
    /** Triangles of each complete group. */
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

/** Returns the cube with a ring's map. */
export function cubeOf(region: Region, ring: number): Cube {
  const cubeOfRing = region.cubes.find((cube) => cube.ringShown === ring);
  if (!cubeOfRing) throw new Error(`the map of ring ${ring} is missing`);
  return cubeOfRing;
}

export function hasMap({ entry }: Region, ring: number): boolean {
  const { map, sharper } = entry.rings[ring] ?? {};
  return Boolean(map ?? sharper);
}

/** Index of the cube for a ring's map. */
export function cubeIndexOf(ring: number): 0 | 1 {
  return ring % 2 === 0 ? 0 : 1;
}

export function meshesOf(group: Group): PieceMesh[] {
  return group.children as PieceMesh[];
}

/** Shows a ring's geometry, or the dynamic objects, when all of it is on the GPU, and records its triangles. */
export function complete(region: Region, ring: number, triangles: Triangles): void {
  (region.groups[ring] as Group).visible = true;
  region.triangles[ring] = triangles;
}

/** Number of triangles in a picture with all rings up to one. */
export function trianglesShown(region: Region, ring: number): Triangles {
  return region.triangles.slice(0, ring + 1).reduce((sum, { inFile, drawn }) => {
    return { inFile: sum.inFile + inFile, drawn: sum.drawn + drawn };
  }, { inFile: 0, drawn: 0 });
}

/** Steps that upload a part of a file's geometry and add it to the group of its ring. */
export function* partSteps(region: Region, ring: number, part: Part, resources: MeshResources, pictures: Pictures) {
  const { bands, pieces } = part;
  // Dynamic objects, in ring 0, also appear beyond the cut.
  const cut = ring === 0 ? Infinity : region.entry.cut;
  const group = region.groups[ring] as Group;
  const ready: { piece: Piece; prepared: Prepared }[] = [];
  const make = (): void => {
    const meshes = ready.splice(0).map(({ piece, prepared }) => {
      const textures = texturesOf(piece.material, (uri) => resources.store.textures.get(uri) ?? null);
      return prepared.make(region.materials.of(piece, textures, cut));
    });
    resources.warmUp(meshes);
    group.add(...meshes);
  };
  try {
    for (const band of bands) yield* pictures.steps(band);
    for (const [number, piece] of pieces.entries()) {
      const prepared = prepare(piece, resources);
      ready.push({ piece, prepared });
      yield* prepared.steps();
      const isLast = number === pieces.length - 1;
      if (ready.length === MESHES_PER_STEP || isLast) yield { kind: 'mesh', bytes: 0, run: make } as const;
    }
  } finally {
    for (const { prepared } of ready) prepared.free();
    for (const { rows } of bands) rows.close();
  }
}
