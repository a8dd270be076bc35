/** Opens the content that the page's address names: a bundle, or a scene whose regions a server makes on demand. */
import { filesOfGeometry, limitRings } from './bundle/contents';
import { BundleError } from './bundle/error';
import type { Manifest, Point } from './bundle/manifest';
import { parseJson, readManifest } from './bundle/parse';
import { createFiles, type Files, readDocument, type Received } from './bundle/source';
import { NETWORK } from './bundle/transfer';
import type { Pose } from './control/pose';
import type { ServerProgress } from './demand/place';
import { isSite, readScene, readSite } from './demand/scene';
import { createDemandWorld } from './demand/world';
import type { Strategy } from './show/stage';
import { type World, worldOf } from './show/world';

/** Opened content. */
export interface Content {
  readonly world: World;
  readonly files: Files;
  /** Name of the scene; null if unknown. */
  readonly title: string | null;
  /** Triangles of the whole scene. */
  readonly triangles: number;
  readonly isStatic: boolean;
  /** Files of dynamic objects, which every region needs; empty if regions list their own. */
  readonly movingFiles: readonly string[];
  /** First pose, if the page's address has none. */
  readonly start: Pose;
  /** Centres of all regions; null if regions are made anywhere on demand. */
  readonly centers: readonly Point[] | null;
  /** Progress of the server with a region; null for bundles. */
  progressOf(region: number): ServerProgress | null;
}

/** Opens the content at a base URL; `onWait` is called when the server may still be loading the scene. */
export async function openContent(
  base: URL,
  query: URLSearchParams,
  strategy: Strategy,
  received: Received,
  onWait: () => void,
): Promise<Content> {
  const { signal } = new AbortController();
  const document = parseJson('manifest.json', await readDocument(base, received, signal));
  const lastRing = query.get('rings');
  if (!isSite(document)) {
    const bundleManifest = readManifest(document);
    return openBundle(base, bundleManifest, limitRings(lastRing, strategy.arrange(bundleManifest)), received);
  }
  if (!strategy.isByRings)
    throw new BundleError('strategy: expected clovr or clovrd with a scene whose regions are made on demand', 'address');
  const site = readSite(document);
  onWait();
  const scene = await readScene(base, site, signal, NETWORK);
  const world = createDemandWorld({ base, site, scene, lastRing, received, network: NETWORK });
  return {
    world,
    files: world.files,
    title: site.title,
    triangles: scene.triangles,
    isStatic: scene.isStatic,
    movingFiles: [],
    start: { ...scene.start, pitch: 0 },
    centers: null,
    progressOf: world.progressOf,
  };
}

/** Opens the regions and rings of `manifest`; the original manifest lists the files. */
function openBundle(base: URL, { files }: Manifest, manifest: Manifest, received: Received): Content {
  const { dynamic, regions, triangles } = manifest;
  const [first] = regions;
  if (!first) throw new BundleError('manifest.json: expected a region, got none');
  return {
    world: worldOf(manifest),
    files: createFiles(base, (name) => files[name], received),
    title: null,
    triangles,
    isStatic: dynamic === null,
    movingFiles: dynamic ? filesOfGeometry(dynamic) : [],
    start: { position: first.center, yaw: 0, pitch: 0 },
    centers: regions.map(({ center }) => center),
    progressOf: () => null,
  };
}
