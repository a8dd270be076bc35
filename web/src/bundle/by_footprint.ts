/** Converts a bundle for the strategies vis0 and vis1: rings whose map comes last. */
import { BundleError } from './error';
import type { Manifest, RegionEntry, RingEntry } from './manifest';

/** Bundle whose rings are portions of objects by footprint; the last ring has only the map. */
export function byFootprint(manifest: Manifest): Manifest {
  return { ...manifest, regions: manifest.regions.map(inPortions) };
}

function inPortions(region: RegionEntry, number: number): RegionEntry {
  const { by_footprint: other, rings } = region;
  if (!other) {
    const place = `manifest.json: regions[${number}].by_footprint`;
    throw new BundleError(`${place}: expected objects by footprint, got none: export the scene with by_footprint=True`, 'address');
  }
  // All portions are shown with the last ring's morph.
  const radius = rings[rings.length - 1]?.radius ?? 0;
  const none = { objects: 0, triangles: 0, geometry: null, parts: [] };
  const portions = other.portions.map((portion): RingEntry => ({ ...portion, radius, map: null }));
  return { ...region, rings: [{ ...none, radius: 0, map: null }, ...portions, { ...none, radius, map: other.map }] };
}
