/** Four strategies to load near geometry, compared in CloVR (2024). */
import { byFootprint } from '../bundle/by_footprint';
import { BundleError } from '../bundle/error';
import type { Manifest } from '../bundle/manifest';
import type { Manner } from './stage';

export interface Strategy extends Manner {
  /** Returns the manifest in the order of loading. */
  readonly arrange: (manifest: Manifest) => Manifest;
  /** Whether it loads the rings of the bundle, as servers make them on demand. */
  readonly isByRings: boolean;
}

const asItIs = (manifest: Manifest): Manifest => manifest;

const STRATEGIES: Readonly<Record<string, Strategy>> = {
  clovr: { isSmooth: true, isWhole: false, arrange: asItIs, isByRings: true },
  // Shows rings at once instead of smoothly.
  clovrd: { isSmooth: false, isWhole: false, arrange: asItIs, isByRings: true },
  // Shows nothing until everything that the centre sees is loaded.
  vis0: { isSmooth: false, isWhole: true, arrange: byFootprint, isByRings: false },
  // Shows objects as they arrive, the largest footprints first.
  vis1: { isSmooth: false, isWhole: false, arrange: byFootprint, isByRings: false },
};

/** Returns the strategy of a name in an address; clovr by default. */
export function strategyOf(name: string | null): Strategy {
  const found = Object.hasOwn(STRATEGIES, name ?? 'clovr') ? STRATEGIES[name ?? 'clovr'] : undefined;
  if (!found) {
    throw new BundleError(`strategy: expected ${Object.keys(STRATEGIES).join(', ')}, got ${name ?? ''}`, 'address');
  }
  return found;
}
