/** Contents of files that a page can give to others, by their keys; the oldest ones make place. */

/** Bytes that are kept. */
const MOST_BYTES = 64 * 2 ** 20;

export interface Store {
  readonly keys: readonly string[];
  has(key: string): boolean;
  /** The content; null if it is not there. */
  find(key: string): Blob | null;
  /** Keep a content, which is checked; the answer names those that had to go. */
  add(key: string, data: ArrayBuffer): readonly string[];
}

/** Blobs, since browsers may keep them on disk. */
export function createStore(most: number = MOST_BYTES): Store {
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
      // The last one that was asked for goes last.
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
