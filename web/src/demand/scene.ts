/**
 * Documents of a scene whose regions are made on demand: the manifest, and the scene document, which may take a while.
 */
import { fileName, integer, number, object, optional, text } from '../bundle/checks';
import { BundleError } from '../bundle/error';
import { parseJson, point } from '../bundle/parse';
import type { Network } from '../bundle/transfer';
import { request } from './request';

const [FORMAT, SCENE, VERSION] = ['nearfar.on_demand', 'nearfar.scene', 1] as const;

/** Manifest of a scene whose regions are made on demand. */
export type Site = ReturnType<typeof readSite>;
export type SceneFacts = Awaited<ReturnType<typeof readScene>>;

/** Whether a manifest is that of a scene whose regions are made on demand, not that of a bundle. */
export function isSite(document: unknown): boolean {
  return typeof document === 'object' && document !== null && (document as { format?: unknown }).format === FORMAT;
}

export function readSite(document: unknown) {
  const all = object('manifest', document);
  checkVersion(all['version']);
  return {
    title: text('title', all['title']),
    /** Spacing of the grid of places, metres. */
    grid: number('grid', all['grid'], 1e-3, 1e6),
    /** Name of the scene document. */
    scene: fileName('scene', all['scene']),
  };
}

/** Fetches the scene document, which the server sends when it has loaded the scene. */
export async function readScene(base: URL, { scene }: Site, signal: AbortSignal, network: Network) {
  const response = await request(new URL(scene, base), 'scene', () => undefined, signal, network);
  const all = object('scene', parseJson('scene', await response.text()));
  if (all['format'] !== SCENE) throw new BundleError(`${scene}: expected the format ${SCENE}, got another one`);
  checkVersion(all['version']);
  const failed = optional('failed', all['failed'], text);
  if (failed !== null) throw new BundleError(failed, 'scene');
  const [start, growth] = [object('start', all['start']), object('growth', all['growth'])];
  return {
    triangles: integer('triangles', all['triangles'], 0),
    /** First pose, if the page's address has none. */
    start: { position: point('start.position', start['position']), yaw: number('start.yaw', start['yaw'], -7, 7) },
    faceSize: integer('face_size', all['face_size'], 1, 4096),
    nearShare: number('near_share', all['near_share'], 0, 1 - 1e-9),
    fade: number('growth.fade', growth['fade'], 0),
    /** Whether nothing moves. */
    isStatic: all['is_static'] === true,
  };
}

function checkVersion(value: unknown): void {
  const version = integer('version', value, 1);
  if (version > VERSION) {
    const versions = `it has version ${version}, this page reads ${VERSION}`;
    throw new BundleError(`this server runs a newer nearfar (${versions}): reload the page`, 'newer');
  }
}
