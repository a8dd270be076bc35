/** Page for flying through a tree of orthoviews. */
import { messageOf } from '../base/errors';
import { type Pose, readLink, writeLink } from '../control/pose';
import { createMeter } from '../show/meter';
import { find } from '../ui/dom';
import { showFatal, showProblems } from '../ui/messages';
import { createThumbMark } from '../ui/overlays';
import { cameraOf } from './cut/camera';
import { createFly, startPose } from './fly';
import { createPanel } from './panel';
import type { Facts, Graphics } from './show/resident';
import { Viewer } from './show/viewer';
import { canRetry, type Failure } from './store/error';
import type { Layout } from './store/layout';

/** Vertical field of view, radians. */
const FIELD_OF_VIEW = Math.PI / 3;
/** Greatest number of canvas pixels per CSS pixel along an axis: phones cannot draw enough splats for more. */
const MAX_PIXEL_RATIO = 1.5;
/** Seconds between two updates of the panel. */
const PANEL_SECONDS = 0.25;
/** Least seconds between two updates of the address. */
const LINK_SECONDS = 0.5;
/** Default GPU memory for views: 512 MiB, or a quarter of it on small screens. */
const DEFAULT_BYTES = 1 << 29;

declare global {
  interface Window {
    /** Interface for scripts and tests. */
    orthoview?: {
      readonly facts: Facts;
      readonly pose: Pose;
      readonly received: number;
      setPose(pose: Pose): void;
      /** Draws the last picture again; returns the milliseconds until the GPU has finished it. */
      time(): Promise<number>;
    };
  }
}

function main(): void {
  const query = new URLSearchParams(location.search);
  const [canvas, root] = [find('canvas', HTMLCanvasElement), find('#ui', HTMLElement)];
  const isSmall = Math.min(screen.width, screen.height) < 600;
  const meter = createMeter();
  const fatal = ({ kind, message }: Failure): void => {
    const { title, text } = FATAL[kind];
    showFatal(title, text, { detail: message, retry: () => location.reload() });
  };
  let problems: readonly Failure[] = [];
  const show = (now: readonly Failure[]): void => {
    problems = now;
    showProblems(problems.map(({ message }) => message), retry);
  };
  const viewer = new Viewer(canvas, {
    base: folderOf(new URL(query.get('store') ?? '.', location.href)),
    scripts: {
      cutter: new URL('orthoview-cut.js', import.meta.url),
      reader: new URL('orthoview-read.js', import.meta.url),
      webgpu: new URL('orthoview-webgpu.js', import.meta.url),
    },
    views: numberOf(query, 'views', 3, 1, 8),
    error: numberOf(query, 'error', 1, 0.1, 64),
    geometry: query.get('geometry') !== '0',
    raiseDegrees: numberOf(query, 'lift', 0, 0, 90),
    samplesPerAxis: Math.round(Math.sqrt(numberOf(query, 'samples', 1, 1, 16))),
    graphics: graphicsOf(query.get('graphics')),
    maxViewBytes: numberOf(query, 'megabytes', (isSmall ? DEFAULT_BYTES / 4 : DEFAULT_BYTES) >> 20, 1, 1 << 14) * 2 ** 20,
    workers: Math.min(Math.max((navigator.hardwareConcurrency || 2) - 1, 1), 4),
    onReceived: meter.receive,
    onOpen,
    onFailure(failure, isFatal) {
      if (isFatal) return fatal(failure);
      const isTemporary = canRetry(failure);
      const report = isTemporary ? { ...failure, message: `${failure.message}; ${RETRY_NOTE}` } : failure;
      const isSame = ({ kind, message }: Failure): boolean =>
        isTemporary ? kind === report.kind : message === report.message;
      if (!problems.some(isSame)) show([...problems, report]);
    },
    onRecovered: () => show(problems.filter((failure) => !canRetry(failure))),
  });
  let [ground, home]: [number, Pose] = [0, { position: [0, 0, 0], yaw: 0, pitch: 0 }];
  const linkedPose = readLink(location.hash);
  const fly = createFly(canvas, linkedPose ?? home, () => ground, createThumbMark(root).show);
  const panel = createPanel(root, () => fly.setPose(home));
  window.addEventListener('hashchange', () => fly.setPose(readLink(location.hash) ?? fly.pose));
  canvas.addEventListener('webglcontextlost', () => fatal({ kind: 'other', message: GRAPHICS_LOST }));

  function onOpen(layout: Layout): void {
    ground = layout.origin[1];
    home = startPose(layout);
    if (!linkedPose) fly.setPose(home);
    isOpen = true;
  }

  function retry(): void {
    show([]);
    viewer.retry();
  }

  let [lastTime, sincePanel, sinceLink]: [number, number, number] = [performance.now(), PANEL_SECONDS, 0];
  let [lastLink, isOpen] = ['', false];
  window.orthoview = {
    get facts() {
      return viewer.facts;
    },
    get pose() {
      return fly.pose;
    },
    get received() {
      return meter.read().received;
    },
    setPose: fly.setPose,
    time: () => viewer.time(),
  };

  function frame(now: number): void {
    const seconds = Math.max(now - lastTime, 0) / 1000;
    lastTime = now;
    const pose = fly.update(seconds);
    const ratio = Math.min(window.devicePixelRatio || 1, MAX_PIXEL_RATIO);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((size) =>
      Math.max(Math.round(size * ratio), 1),
    );
    if (canvas.width !== width || canvas.height !== height)
      [canvas.width, canvas.height] = [width as number, height as number];
    viewer.frame(cameraOf(pose, FIELD_OF_VIEW, canvas.width, canvas.height));
    sincePanel += seconds;
    sinceLink += seconds;
    if (sincePanel >= PANEL_SECONDS) {
      sincePanel = 0;
      const { received, rate } = meter.read();
      panel.update({
        facts: viewer.facts,
        frame: viewer.drawMs,
        received,
        rate,
        height: pose.position[1] - ground,
        speedExponent: fly.speedExponent,
      });
    }
    const link = writeLink(pose);
    if (isOpen && sinceLink >= LINK_SECONDS && link !== lastLink) {
      // Browsers reject more than a few hundred changes of the address in half a minute.
      [sinceLink, lastLink] = [0, link];
      history.replaceState(null, '', link);
    }
    requestAnimationFrame(frame);
  }
  requestAnimationFrame(frame);
}

const RETRY_NOTE = 'loaded views stay visible, and the others are requested again';
const GRAPHICS_LOST = 'The browser has reset the graphics.';

/** Titles and texts of failures after which nothing can be shown. */
const FATAL: Readonly<Record<Failure['kind'], { readonly title: string; readonly text: string }>> = {
  gone: {
    title: 'There is no tree at this address',
    text: 'The page shows the store of orthoviews in its own folder, or the one that ?store= in the address names.',
  },
  refused: { title: 'The server refuses the tree', text: 'Send the message below to the administrator of the server.' },
  unreachable: { title: 'The tree cannot be reached', text: 'Check the connection and the address, and try again.' },
  damaged: {
    title: 'The tree is damaged',
    text: 'A file differs from what the build wrote. Check it with nearfar orthoview verify.',
  },
  newer: { title: 'The tree needs a newer nearfar', text: 'The format of the tree is newer than this page.' },
  other: {
    title: 'The tree cannot be shown',
    text: 'Reload the page. If that does not help, send the message below to the sender of the link.',
  },
};

function graphicsOf(name: string | null): Graphics | null {
  return name === 'webgl' || name === 'webgpu' ? name : null;
}

/** Adds a slash to the end of an address, and removes its fragment. */
function folderOf(url: URL): URL {
  if (!url.pathname.endsWith('/')) url.pathname += '/';
  url.hash = '';
  return url;
}

function numberOf(query: URLSearchParams, name: string, fallback: number, least: number, greatest: number): number {
  const text = query.get(name);
  const value = text === null || text === '' ? fallback : Number(text);
  return Number.isFinite(value) ? Math.min(Math.max(value, least), greatest) : fallback;
}

try {
  main();
} catch (reason) {
  const { title, text } = FATAL.other;
  showFatal(title, text, { detail: messageOf(reason) });
}
