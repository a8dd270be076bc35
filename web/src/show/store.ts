/** Things that regions share on the GPU and in the worker: textures, buffers, and the arrays of meshes. */
import type { Texture } from 'three';
import type { Buffers } from './buffers';

/** The arrays of a mesh without its placements. */
export type MeshArrays = Buffers<'position' | 'normal' | 'uv' | 'color' | 'index'>;

export interface Store {
  /** By names of files. */
  readonly textures: Map<string, Texture>;
  /** Names of the files that the worker for geometry has: shared buffers, and that of dynamic objects. */
  readonly buffers: Set<string>;
  /** Arrays of a mesh: those that another one with the same name has, if there is one. */
  take(name: string | null, make: () => MeshArrays): MeshArrays;
  /** A mesh has gone; true if no other one uses its arrays. */
  give(name: string | null): boolean;
  /** Let go of all files but these; returns buffers for the worker to let go of. */
  keep(files: ReadonlySet<string>): string[];
  /** Meshes whose arrays more than one uses. */
  readonly shared: number;
}

export function createStore(): Store {
  const textures = new Map<string, Texture>();
  const buffers = new Set<string>();
  const held = new Map<string, { arrays: MeshArrays; users: number }>();

  return {
    textures,
    buffers,
    take(name, make) {
      if (name === null) return make();
      const entry = held.get(name) ?? { arrays: make(), users: 0 };
      held.set(name, entry);
      entry.users += 1;
      return entry.arrays;
    },
    give(name) {
      const entry = name === null ? undefined : held.get(name);
      if (!entry || name === null) return true;
      entry.users -= 1;
      if (entry.users > 0) return false;
      held.delete(name);
      return true;
    },
    keep(files) {
      for (const [name, texture] of textures) {
        if (files.has(name)) continue;
        texture.dispose();
        textures.delete(name);
      }
      const gone = [...buffers].filter((name) => !files.has(name));
      for (const name of gone) buffers.delete(name);
      return gone;
    },
    get shared() {
      return [...held.values()].filter(({ users }) => users > 1).length;
    },
  };
}
