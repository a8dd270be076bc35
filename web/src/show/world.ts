/** All that a viewer can show: the places of regions, and how to come by each. */
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
  /** Of a radius of the morph: how far from the centre its picture does not fold. */
  readonly marginShare: number;
  /** Seconds of a cross-fade. */
  readonly fade: number;
  /** Come by a region; the signal is aborted when nobody wants it any more. */
  open(region: number, signal: AbortSignal): Promise<Coming>;
}

/** The regions of a bundle. */
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

/** The fold margin as a share of the morph's radius: of the cylinder it is its near part, at any radius. */
function marginShareOf({ morph, regions }: Manifest): number {
  const [first] = regions;
  if (!first || !Number.isFinite(first.cut)) return morph.near_share;
  return Math.max(first.fold_margin / first.cut, Number.EPSILON);
}
