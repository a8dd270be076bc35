/** Content of a viewer: the places of regions, and access to each. */
import type { Coming } from '../bundle/coming';
import { thereOf } from '../bundle/coming';
import type { Manifest } from '../bundle/manifest';
import { knownPlaces, type Places } from './places';

export interface World {
  readonly places: Places;
  /** Texels along an edge of a map of full size. */
  readonly faceSize: number;
  /** n: nothing moves within n R. */
  readonly nearShare: number;
  /** Share of a morph's radius within which its picture does not fold. */
  readonly marginShare: number;
  /** Duration of a cross-fade, seconds. */
  readonly fade: number;
  /** Opens a region; the signal is aborted when it is no longer needed. */
  open(region: number, signal: AbortSignal): Promise<Coming>;
}

/** World of a bundle's regions. */
export function worldOf(manifest: Manifest): World {
  return {
    places: knownPlaces(manifest.regions),
    faceSize: manifest.map.face_size,
    nearShare: manifest.morph.near_share,
    marginShare: marginShareOf(manifest),
    fade: manifest.growth.fade,
    open: (region) => Promise.resolve(thereOf(manifest, region)),
  };
}

/** Returns the fold margin as a share of the morph's radius: for the cylinder morph the near share. */
function marginShareOf({ morph, regions }: Manifest): number {
  const [first] = regions;
  if (!first || !Number.isFinite(first.cut)) return morph.near_share;
  return Math.max(first.fold_margin / first.cut, Number.EPSILON);
}
