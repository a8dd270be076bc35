/** A region whose parts may arrive over time, in the order of its rings. */
import type { Manifest, RegionEntry, RingEntry } from './manifest';

export interface Coming {
  /** Manifest of the region's bundle; lists files once they can be fetched. */
  readonly manifest: Manifest;
  /** Rings that have not arrived have neither geometry nor map. */
  readonly entry: RegionEntry;
  /** Resolves a ring once its files can be fetched. */
  ring(number: number): RingEntry | Promise<RingEntry>;
}

/** A region of a bundle that is complete. */
export function thereOf(manifest: Manifest, number: number): Coming {
  const entry = manifest.regions[number];
  if (!entry) throw new Error(`there is no region ${number}`);
  return {
    manifest,
    entry,
    ring(order) {
      const ring = entry.rings[order];
      if (!ring) throw new Error(`region ${number} has no ring ${order}`);
      return ring;
    },
  };
}
