/** A bundle without its outer rings, as `?rings=` in the address asks for it. */
import { BundleError } from './error';
import type { Manifest } from './manifest';

/** The bundle up to a ring, whose number comes as text; all of it where there is none. */
export function upTo(last: string | null, manifest: Manifest): Manifest {
  if (last === null) return manifest;
  if (!/^\d{1,4}$/.test(last)) throw new BundleError(`rings: expected the number of a ring, got ${last}`, 'address');
  const count = Number(last) + 1;
  return { ...manifest, regions: manifest.regions.map((region) => ({ ...region, rings: region.rings.slice(0, count) })) };
}
