/** Least recently used cache of file contents that a page can give to others, by key. */

/** Greatest number of stored bytes. */
const MAX_BYTES = 64 * 2 ** 20;

export interface Store {
  readonly keys: readonly string[];
  has(key: string): boolean;
  /** Returns the content; null if it is not stored. */
  find(key: string): Blob | null;
  /** Stores a verified content; returns the evicted keys. */
  add(key: string, data: ArrayBuffer): readonly string[];
}

/** Creates a store of blobs, which browsers may keep on disk. */
export function createStore(most: number = MAX_BYTES): Store {
  const kept = new Map<string, Blob>();
  let bytes = 0;

  function remove(key: string): void {
    bytes -= kept.get(key)?.size ?? 0;
    kept.delete(key);
  }

  return {
    get keys() {
      return [...kept.keys()];
    },
    has: (key) => kept.has(key),
    find(key) {
      const found = kept.get(key);
      if (!found) return null;
      // The most recently requested content is evicted last.
      kept.delete(key);
      kept.set(key, found);
      return found;
    },
    add(key, data) {
      if (data.byteLength > most) return [];
      remove(key);
      kept.set(key, new Blob([data]));
      bytes += data.byteLength;
      const gone: string[] = [];
      for (const oldest of kept.keys()) {
        if (bytes <= most) break;
        remove(oldest);
        gone.push(oldest);
      }
      return gone;
    },
  };
}
