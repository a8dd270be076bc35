/** Facts of the picture, for the panel and for tests. */
import type { RegionEntry } from '../bundle/manifest';
import type { Bounds } from '../control/limit';
import type { Triangles } from '../decode/messages';
import type { Atlas, Holding, OpenRegion } from './atlas';
import type { Store } from './buffers';
import type { Journey, Leg } from './journey';
import { trianglesShown } from './region';

export interface Facts extends Holding, Readonly<Pick<OpenRegion, 'shown' | 'arrived' | 'received' | 'expected'>> {
  readonly region: number;
  /** Entry of the region; null before its manifest is loaded. */
  readonly entry: RegionEntry | null;
  /** Region that the user is moving to; null for none. */
  readonly goal: number | null;
  readonly triangles: Triangles;
  /** Milliseconds spent on uploads and answers of workers in the last frame. */
  readonly upload: number;
  /** Area where the user may be. */
  readonly bounds: Bounds | null;
  /** Region whose picture fades out; null for none. */
  readonly leaving: number | null;
  /** Number of arrays that several meshes share. */
  readonly shared: number;
}

/** Facts of a journey and its last leg; both are null before a region is open. */
export function factsOf(journey: Journey | null, leg: Leg | null, atlas: Atlas, store: Store, upload: number): Facts {
  const region = journey?.region ?? 0;
  const open = atlas.find(region);
  const ring = open?.shown?.fading?.ring ?? open?.shown?.ring ?? 0;
  return {
    region,
    entry: open?.region.entry ?? null,
    goal: journey?.goal ?? null,
    leaving: leg?.leaving?.region ?? null,
    shown: open?.shown ?? null,
    arrived: open?.arrived ?? -1,
    received: open?.received ?? 0,
    expected: open?.expected ?? 0,
    triangles: open ? trianglesShown(open.region, ring) : { own: 0, drawn: 0 },
    upload,
    bounds: journey?.bounds ?? null,
    ...atlas.holding,
    shared: store.shared,
  };
}
