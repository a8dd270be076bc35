/** The four ways to load near geometry that CloVR (2024) compares. */
import { byFootprint } from '../bundle/by_footprint';
import { BundleError } from '../bundle/error';
import type { Manifest } from '../bundle/manifest';
import type { Manner } from './stage';

export interface Strategy extends Manner {
  /** The bundle as it is loaded. */
  readonly arrange: (manifest: Manifest) => Manifest;
  /** It loads the rings of the bundle, as servers make them on demand. */
  readonly isByRings: boolean;
}

const asItIs = (manifest: Manifest): Manifest => manifest;

const STRATEGIES: Readonly<Record<string, Strategy>> = {
  clovr: { isSmooth: true, isWhole: false, arrange: asItIs, isByRings: true },
  // Rings at once instead of smoothly.
  clovrd: { isSmooth: false, isWhole: false, arrange: asItIs, isByRings: true },
  // Nothing until all that the centre sees is there.
  vis0: { isSmooth: false, isWhole: true, arrange: byFootprint, isByRings: false },
  // Objects as they come, the largest footprints first.
  vis1: { isSmooth: false, isWhole: false, arrange: byFootprint, isByRings: false },
};

/** The strategy of a name, as addresses have it; clovr if there is none. */
export function strategyOf(name: string | null): Strategy {
  const found = Object.hasOwn(STRATEGIES, name ?? 'clovr') ? STRATEGIES[name ?? 'clovr'] : undefined;
  if (!found) {
    throw new BundleError(`strategy: expected ${Object.keys(STRATEGIES).join(', ')}, got ${name ?? ''}`, 'address');
  }
  return found;
}
