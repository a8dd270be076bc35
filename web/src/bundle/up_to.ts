/** Bundle without its outer rings, for the address parameter `?rings=`. */
import { BundleError } from './error';
import type { Manifest } from './manifest';

/** Bundle up to a ring, whose number is given as text; the whole bundle for null. */
export function upTo(last: string | null, manifest: Manifest): Manifest {
  if (last === null) return manifest;
  if (!/^\d{1,4}$/.test(last)) throw new BundleError(`rings: expected the number of a ring, got ${last}`, 'address');
  const count = Number(last) + 1;
  return { ...manifest, regions: manifest.regions.map((region) => ({ ...region, rings: region.rings.slice(0, count) })) };
}
