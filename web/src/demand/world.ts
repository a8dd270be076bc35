/** World whose regions a server makes on demand, at any point of a grid. */
import type { FileEntry } from '../bundle/manifest';
import { createFiles, type Files, MAX_MANIFEST, type Received } from '../bundle/source';
import type { Network } from '../bundle/transfer';
import { distance } from '../control/limit';
import type { Vector } from '../control/pose';
import type { Places, Spot, World } from '../show/world';
import { readPlace, type ServerProgress } from './place';
import { linesOf, request } from './request';
import type { SceneFacts, Site } from './scene';

export interface DemandSettings {
  readonly base: URL;
  readonly site: Site;
  readonly scene: SceneFacts;
  /** Last ring to request, as text; null for all rings. */
  readonly lastRing: string | null;
  readonly received: Received;
  readonly network: Network;
}

export interface DemandWorld extends World {
  readonly files: Files;
  /** Progress of the server with a region; null for regions that are not open. */
  progressOf(region: number): ServerProgress | null;
}

export function createDemandWorld({ base, site, scene, lastRing, received, network }: DemandSettings): DemandWorld {
  const grid = createGrid(site.grid);
  const progressByRegion = new Map<number, ServerProgress>();
  // Files are named by their content, so that equal names of different places mean equal files.
  const entries = new Map<string, FileEntry>();
  return {
    places: grid,
    faceSize: scene.faceSize,
    nearShare: scene.nearShare,
    marginShare: scene.nearShare,
    fade: scene.fade,
    files: createFiles(base, (name) => entries.get(name), received, network),
    async open(region, signal) {
      const report = (progress: ServerProgress): void => {
        if (!signal.aborted) progressByRegion.set(region, progress);
      };
      const name = `at/${grid.spotOf(region).center.join()}/parts`;
      report({ stage: 'requested' });
      signal.addEventListener('abort', () => progressByRegion.delete(region), { once: true });
      const reportBusy = (seconds: number): void => report({ stage: 'busy', seconds });
      const answer = await request(new URL(name, base), 'place', reportBusy, signal, network);
      const place = await readPlace(linesOf('parts', answer, MAX_MANIFEST), lastRing, {
        onFiles(files) {
          for (const [file, entry] of Object.entries(files)) entries.set(file, entry);
        },
        onProgress: report,
      });
      grid.record(region, place.entry);
      return place;
    },
    progressOf: (region) => progressByRegion.get(region) ?? null,
  };
}

/** Step to which a server rounds the height of a place, metres. */
const HEIGHT_STEP = 1 / 8;
/** The next place is requested when the user is nearer to the limit than this share of it. */
const REQUEST_SHARE = 0.5;
/** A requested place is dropped when the user is farther from the limit than this share of it. */
const DROP_SHARE = 0.6;
/** A requested place is kept while it is nearer to the user than this share of the distance to the current centre. */
const KEEP_SHARE = 0.6;

export function createGrid(spacing: number): Places & { record(region: number, spot: Spot): void } {
  const regionByName = new Map<string, number>();
  const spots: Spot[] = [];
  const spotOf = (region: number): Spot => spots[region] as Spot;

  function nearest([x, y, z]: Vector): number {
    const center: Vector = [snap(x, spacing), snap(y, HEIGHT_STEP), snap(z, spacing)];
    const name = center.join();
    const region = regionByName.get(name);
    if (region !== undefined) return region;
    // The margin is unknown; users who request the region are at most this far away.
    spots.push({ center, fold_margin: spacing });
    regionByName.set(name, spots.length - 1);
    return spots.length - 1;
  }

  return {
    spotOf,
    nearest,
    /** Returns the region at the user's place if the current limit is near, or the preloaded one while it is near. */
    regionToPreload({ place, current, preloaded, limit }) {
      const remaining = limit.metres - distance(place, limit);
      if (remaining > (preloaded === null ? REQUEST_SHARE : DROP_SHARE) * limit.metres) return null;
      const distanceTo = (region: number): number => distance(place, { center: spotOf(region).center, metres: 0 });
      const isKept = preloaded !== null && preloaded !== current;
      if (isKept && distanceTo(preloaded) <= KEEP_SHARE * distanceTo(current)) return preloaded;
      const nearestRegion = nearest(place);
      return nearestRegion === current ? null : nearestRegion;
    },
    record(region, spot) {
      spots[region] = spot;
    },
  };
}

function snap(value: number, step: number): number {
  // Adding 0 turns −0 into 0, so that both have one name.
  return step * Math.round(value / step) + 0;
}
