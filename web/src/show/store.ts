/** Resources that regions share on the GPU and in the worker: textures, buffers, and arrays of meshes. */
import type { Texture } from 'three';
import type { Buffers } from './buffers';

/** Arrays of a mesh without its placements. */
export type MeshArrays = Buffers<'position' | 'normal' | 'uv' | 'color' | 'index'>;

export interface Store {
  /** Textures by file name. */
  readonly textures: Map<string, Texture>;
  /** Names of the files in the geometry worker: shared buffers, and the file of dynamic objects. */
  readonly buffers: Set<string>;
  /** Returns the arrays of a mesh, shared with other meshes of the same name; counts a user. */
  take(name: string | null, make: () => MeshArrays): MeshArrays;
  /** Releases a mesh's arrays; returns true if no other mesh uses them. */
  give(name: string | null): boolean;
  /** Frees all files but these; returns the buffers that the worker must free. */
  keep(files: ReadonlySet<string>): string[];
  /** Number of arrays that several meshes share. */
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
