/** The page: opens the bundle that its address names, and draws it for whoever looks. */
import { BundleError } from './bundle/error';
import type { Manifest, RegionEntry } from './bundle/manifest';
import { openSource } from './bundle/source';
import { createControls } from './control/controls';
import { readLink, writeLink } from './control/link';
import type { Pose } from './control/pose';
import { createMeter } from './show/meter';
import { createViewer, type Viewer } from './show/viewer';
import { createDivider } from './ui/divider';
import { clearMessage, FATAL, showFatal, showProblems } from './ui/messages';
import { createPanel } from './ui/panel';
import { createThumbMark } from './ui/thumb';

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
  const [canvas, root] = [element('canvas', HTMLCanvasElement), element('#ui', HTMLElement)];
  const meter = createMeter();
  const base = new URL(query.get('bundle') ?? '.', location.href);
  const source = await openSource(base, meter.receive, new AbortController().signal);
  meter.restart();
  const { manifest } = source;
  const region = manifest.regions[0];
  if (!region) throw new BundleError('manifest.json: expected a region, got none');
  let problems: readonly string[] = [];
  const retry = (): void => {
    problems = [];
    clearMessage();
    meter.restart();
    viewer.open(0);
  };
  const viewer = createViewer(canvas, {
    manifest,
    fetch: source.fetch,
    last: Number.parseInt(query.get('rings') ?? '', 10) || region.rings.length,
    worker: new URL('worker.js', import.meta.url),
    angle: ANGLE,
    antialias: query.get('aa') !== '0',
    isSmooth: query.get('strategy') !== 'clovrd',
    failed(reason) {
      problems = [reason.message];
      // Without ring 0 there is no picture to keep.
      if (viewer.facts.arrived < 0) tell(reason);
      else showProblems(problems, retry);
    },
  });
  const home: Pose = { position: region.center, yaw: 0, pitch: 0 };
  const thumb = createThumbMark(root);
  const controls = createControls(canvas, { start: readLink(location.hash) ?? home, onThumb: thumb.show });
  controls.setLimit(region.center, region.fold_margin);
  let pose = controls.update(0);
  window.nearfar = { viewer, setPose: controls.setPose };
  window.addEventListener('hashchange', () => controls.setPose(readLink(location.hash) ?? pose));
  const divider = createDivider(root, (share) => {
    viewer.setDivider(share);
    panel.reflect({ isDivided: share !== null });
  });
  const panel = createPanel(root, {
    setDivider: divider.set,
    setMode: controls.setMode,
    home: () => controls.setPose(home),
    screenshot: viewer.photo,
    link: () => new URL(writeLink(pose), location.href).href,
    retry,
  });
  viewer.open(0);
  const rings = region.rings.length - 1;
  const expected = bytesOf(manifest, region);
  let last = performance.now();
  let sincePanel = PANEL_EVERY;
  viewer.renderer.setAnimationLoop((now: number) => {
    const seconds = Math.max(now - last, 0) / 1000;
    last = now;
    pose = controls.update(seconds);
    viewer.frame(pose, Math.min(seconds, LONGEST_FRAME));
    meter.frame(seconds);
    sincePanel += seconds;
    if (sincePanel < PANEL_EVERY) return;
    sincePanel = 0;
    const { shown, triangles } = viewer.facts;
    panel.update({
      ring: shown?.ring ?? 0,
      rings,
      radius: shown?.grown.radius ?? 0,
      expected,
      ...meter.read(),
      triangles,
      sceneTriangles: manifest.triangles,
      region: 0,
      regions: manifest.regions.length,
      away: Math.hypot(pose.position[0] - region.center[0], pose.position[2] - region.center[2]),
      foldMargin: region.fold_margin,
      problems,
    });
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

/** Say over the whole page why there is nothing to show. */
function tell(reason: unknown): void {
  const detail = reason instanceof Error ? reason.message : String(reason);
  const kinds: readonly [RegExp, keyof typeof FATAL][] = [
    [/newer nearfar/, 'newer'],
    [/does not come|server answers/, 'network'],
    [/WebGL/i, 'webgl'],
    [/expected/, 'damaged'],
  ];
  const { title, text } = FATAL[kinds.find(([pattern]) => pattern.test(detail))?.[1] ?? 'other'];
  showFatal(title, text, { detail, retry: () => location.reload() });
}

main().catch(tell);
