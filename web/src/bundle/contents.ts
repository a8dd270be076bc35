/** Contents of a bundle: names of files, regions whose rings arrive over time, and bundles with other rings. */
import { BundleError } from './error';
import type { GroupEntry, Manifest, MapEntry, RegionEntry, RingEntry } from './manifest';

export function filesOfGeometry({ geometry, parts }: Pick<GroupEntry, 'geometry' | 'parts'>): string[] {
  return geometry === null ? [] : [geometry, ...parts];
}

export function filesOfMap(map: MapEntry | null): string[] {
  return map ? [map.color, map.range].flat().filter((name) => name !== null) : [];
}

export function filesOfRing(ring: RingEntry): string[] {
  return [...filesOfGeometry(ring), ...filesOfMap(ring.map), ...(ring.sharper?.maps ?? []).flatMap(filesOfMap)];
}

/** All files of a region, each once, including those of dynamic objects. */
export function filesOfRegion({ dynamic }: Manifest, { rings }: RegionEntry): Set<string> {
  const moving = dynamic ? filesOfGeometry(dynamic) : [];
  return new Set([...moving, ...rings.flatMap(filesOfRing)]);
}

export function bytesOf({ files }: Manifest, names: Iterable<string>): number {
  return [...names].reduce((sum, name) => sum + (files[name]?.bytes ?? 0), 0);
}

/** Region whose rings arrive over time. */
export interface ArrivingRegion {
  /** Manifest of the region's bundle; lists files once they can be fetched. */
  readonly manifest: Manifest;
  /** Rings that have not arrived have neither geometry nor map. */
  readonly entry: RegionEntry;
  /** Resolves a ring once its files can be fetched. */
  ring(number: number): RingEntry | Promise<RingEntry>;
}

/** Region of a complete bundle, all of whose rings have arrived. */
export function completeRegion(manifest: Manifest, number: number): ArrivingRegion {
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

/** Replaces the rings of a bundle by portions of objects, sorted by footprint; an additional last ring has the map. */
export function orderByFootprint(manifest: Manifest): Manifest {
  return { ...manifest, regions: manifest.regions.map(portionRegion) };
}

function portionRegion(region: RegionEntry, number: number): RegionEntry {
  const { by_footprint: footprint, rings } = region;
  if (!footprint) {
    const place = `manifest.json: regions[${number}].by_footprint`;
    throw new BundleError(`${place}: expected objects by footprint, got none: export the scene with by_footprint=True`, 'address');
  }
  // All portions are shown with the last ring's morph.
  const radius = rings[rings.length - 1]?.radius ?? 0;
  const empty = { objects: 0, triangles: 0, geometry: null, parts: [] };
  const portions = footprint.portions.map((portion): RingEntry => ({ ...portion, radius, map: null }));
  return { ...region, rings: [{ ...empty, radius: 0, map: null }, ...portions, { ...empty, radius, map: footprint.map }] };
}

/** Keeps the rings up to number `last`, a text from the page's address; all rings for null. */
export function limitRings(last: string | null, manifest: Manifest): Manifest {
  if (last === null) return manifest;
  if (!/^\d{1,4}$/.test(last)) throw new BundleError(`rings: expected the number of a ring, got ${last}`, 'address');
  const count = Number(last) + 1;
  return { ...manifest, regions: manifest.regions.map((region) => ({ ...region, rings: region.rings.slice(0, count) })) };
}
