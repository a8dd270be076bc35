/** The page: opens the bundle that its address names, and draws it for whoever looks. */
import { BundleError } from './bundle/error';
import type { Manifest, RegionEntry } from './bundle/manifest';
import { openSource } from './bundle/source';
import type { Pose } from './control/pose';
import { createWalk } from './control/walk';
import { createViewer, type Viewer } from './show/viewer';
import { createPanel } from './ui/panel';

/** Vertical field of view, degrees. */
const ANGLE = 75;
/** Seconds that a frame may stand for: a tab that was hidden goes on where it was. */
const LONGEST_FRAME = 0.1;
/** Seconds between two updates of the panel. */
const PANEL_EVERY = 0.25;

declare global {
  interface Window {
    /** The viewer, for scripts and tests. */
    nearfar?: { readonly viewer: Viewer; setPose(pose: Pose): void };
  }
}

async function main(): Promise<void> {
  const query = new URLSearchParams(location.search);
  const canvas = element('canvas', HTMLCanvasElement);
  let received = 0;
  const count = (bytes: number): void => {
    received += bytes;
  };
  const base = new URL(query.get('bundle') ?? '.', location.href);
  const source = await openSource(base, count, new AbortController().signal);
  received = 0;
  const { manifest } = source;
  const region = manifest.regions[0];
  if (!region) throw new BundleError('manifest.json: expected a region, got none');
  const viewer = createViewer(canvas, {
    manifest,
    fetch: source.fetch,
    last: Number.parseInt(query.get('rings') ?? '', 10) || region.rings.length,
    worker: new URL('worker.js', import.meta.url),
    angle: ANGLE,
    antialias: query.get('aa') !== '0',
    isSmooth: query.get('strategy') !== 'clovrd',
    failed: tell,
  });
  const walk = createWalk(canvas, { position: region.center, yaw: 0, pitch: 0 });
  window.nearfar = { viewer, setPose: walk.setPose };
  viewer.open(0);
  element('#panel', HTMLElement).hidden = false;
  const fill = createPanel(element('#panel', HTMLElement));
  const rings = region.rings.length - 1;
  const expected = bytesOf(manifest, region);
  let last = performance.now();
  let sincePanel = PANEL_EVERY;
  viewer.renderer.setAnimationLoop((now: number) => {
    const seconds = Math.max(now - last, 0) / 1000;
    last = now;
    viewer.frame(walk.update(Math.min(seconds, LONGEST_FRAME)), Math.min(seconds, LONGEST_FRAME));
    sincePanel += seconds;
    if (sincePanel < PANEL_EVERY) return;
    sincePanel = 0;
    const { shown, triangles } = viewer.facts;
    const [ring, radius] = [shown?.ring ?? 0, shown?.grown.radius ?? 0];
    fill({ ring, rings, radius, received, expected, triangles, whole: manifest.triangles, frame: 1000 * seconds });
  });
}

/** Bytes of all files that a region needs. */
function bytesOf({ files, dynamic }: Manifest, { rings }: RegionEntry): number {
  const names = rings.flatMap(({ geometry, parts, map }) => [geometry, ...parts, map.color, map.range].flat());
  const moving = dynamic ? [dynamic.geometry, ...dynamic.parts] : [];
  const all = new Set([...names, ...moving].filter((name) => typeof name === 'string'));
  return [...all].reduce((sum, name) => sum + (files[name]?.bytes ?? 0), 0);
}

function element<T extends HTMLElement>(selector: string, kind: abstract new () => T): T {
  const found = document.querySelector(selector);
  if (!(found instanceof kind)) throw new Error(`the page has no ${selector}`);
  return found;
}

/** Say what went wrong; the last good picture stays. */
function tell(reason: unknown): void {
  const text = reason instanceof Error ? reason.message : String(reason);
  const isGl = /WebGL/i.test(text);
  element('#message', HTMLElement).textContent = isGl ? `This browser cannot draw the scene: it needs WebGL 2. ${text}` : text;
}

main().catch(tell);
