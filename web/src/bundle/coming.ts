/** A region whose parts may come one after the other, in the order of its rings. */
import type { Manifest, RegionEntry, RingEntry } from './manifest';

export interface Coming {
  /** Of the bundle that the region belongs to; files are listed from the time on when they can be fetched. */
  readonly manifest: Manifest;
  /** Rings that have not come have neither geometry nor map. */
  readonly entry: RegionEntry;
  /** A ring whose files can be fetched, as soon as they can. */
  ring(number: number): RingEntry | Promise<RingEntry>;
}

/** A region of a bundle, of which everything is there. */
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
