/** World whose regions a server makes on demand, for any place of a grid. */
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
  /** Address of the site. */
  readonly base: URL;
  readonly site: Site;
  readonly scene: SceneFacts;
  /** Last requested ring, as text; null for all. */
  readonly last: string | null;
  readonly received: Received;
  readonly network: Network;
}

export interface DemandWorld extends World {
  readonly files: Files;
  /** Progress of the server with a region; null for regions that are not open. */
  progressOf(region: number): ServerProgress | null;
}

export function createDemandWorld({ base, site, scene, last, received, network }: DemandSettings): DemandWorld {
  const grid = createGrid(site.grid);
  const makings = new Map<number, ServerProgress>();
  // Files are named by their content, so entries of different places agree.
  const listed = new Map<string, FileEntry>();
  return {
    places: grid,
    faceSize: scene.faceSize,
    nearShare: scene.nearShare,
    marginShare: scene.nearShare,
    fade: scene.fade,
    files: createFiles(base, (name) => listed.get(name), received, network),
    async open(region, signal) {
      const report = (making: ServerProgress): void => {
        if (!signal.aborted) makings.set(region, making);
      };
      const name = `at/${grid.of(region).center.join()}/parts`;
      report({ stage: 'asked' });
      signal.addEventListener('abort', () => makings.delete(region), { once: true });
      const busy = (seconds: number): void => report({ stage: 'busy', seconds });
      const answer = await request(new URL(name, base), 'place', busy, signal, network);
      const coming = await readPlace(linesOf('parts', answer, MAX_MANIFEST), last, {
        listed(files) {
          for (const [file, described] of Object.entries(files)) listed.set(file, described);
        },
        making: report,
      });
      grid.know(region, coming.entry);
      return coming;
    },
    progressOf: (region) => makings.get(region) ?? null,
  };
}

/** Step to which a server rounds the height of a place, metres. */
const HEIGHT = 1 / 8;
/** Remaining share of the limit below which the next place is requested, and above which it is dropped. */
const [ASKED_SHARE, DROPPED_SHARE] = [0.5, 0.6] as const;
/** A requested place is kept while its distance is below this share of the distance to the shown centre. */
const KEPT_SHARE = 0.6;

export interface Grid extends Places {
  /** Records the place of a region. */
  know(region: number, spot: Spot): void;
}

export function createGrid(spacing: number): Grid {
  const numbers = new Map<string, number>();
  const spots: Spot[] = [];
  const of = (region: number): Spot => spots[region] as Spot;

  function nearest([x, y, z]: Vector): number {
    const center: Vector = [snap(x, spacing), snap(y, HEIGHT), snap(z, spacing)];
    const name = center.join();
    const found = numbers.get(name);
    if (found !== undefined) return found;
    // The margin is unknown; users who request the region are at most this far away.
    spots.push({ center, fold_margin: spacing });
    numbers.set(name, spots.length - 1);
    return spots.length - 1;
  }

  return {
    of,
    nearest,
    /** Place of the user, if the shown region is about to end; the previous choice, while it is about as good. */
    ahead({ place, current, ahead, limit }) {
      const left = limit.metres - distance(place, limit);
      if (left > (ahead === null ? ASKED_SHARE : DROPPED_SHARE) * limit.metres) return null;
      const far = (region: number): number => distance(place, { center: of(region).center, metres: 0 });
      if (ahead !== null && ahead !== current && far(ahead) <= KEPT_SHARE * far(current)) return ahead;
      const here = nearest(place);
      return here === current ? null : here;
    },
    know(region, spot) {
      spots[region] = spot;
    },
  };
}

function snap(value: number, step: number): number {
  // Adding 0 turns −0 into 0; −0 has another name.
  return step * Math.round(value / step) + 0;
}
