/** World whose regions a server makes on demand, for any place. */
import type { Described } from '../bundle/manifest';
import { createFiles, type Files, MAX_MANIFEST, type Received } from '../bundle/source';
import type { Network } from '../bundle/transfer';
import type { World } from '../show/world';
import { ask } from './ask';
import { createGrid } from './grid';
import { linesOf } from './lines';
import { type Making, readPlace } from './place';
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
  makingOf(region: number): Making | null;
}

export function createDemandWorld({ base, site, scene, last, received, network }: DemandSettings): DemandWorld {
  const grid = createGrid(site.grid);
  const makings = new Map<number, Making>();
  // Files are named by their content, so entries of different places agree.
  const listed = new Map<string, Described>();
  return {
    places: grid,
    faceSize: scene.faceSize,
    nearShare: scene.nearShare,
    marginShare: scene.nearShare,
    fade: scene.fade,
    files: createFiles(base, (name) => listed.get(name), received, network),
    async open(region, signal) {
      const told = (making: Making): void => {
        if (!signal.aborted) makings.set(region, making);
      };
      const name = `at/${grid.of(region).center.join()}/parts`;
      told({ stage: 'asked' });
      signal.addEventListener('abort', () => makings.delete(region), { once: true });
      const answer = await ask(new URL(name, base), 'place', (seconds) => told({ stage: 'busy', seconds }), signal, network);
      const coming = await readPlace(linesOf('parts', answer, MAX_MANIFEST), last, {
        listed(files) {
          for (const [file, described] of Object.entries(files)) listed.set(file, described);
        },
        making: told,
      });
      grid.know(region, coming.entry);
      return coming;
    },
    makingOf: (region) => makings.get(region) ?? null,
  };
}
