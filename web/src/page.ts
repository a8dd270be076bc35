/** Page that opens the bundle named by its address and draws it. */
import { messageOf } from './base/errors';
import { BundleError, damagedFile } from './bundle/error';
import type { RegionEntry } from './bundle/manifest';
import { createControls } from './control/controls';
import { destinationOf, directionTo } from './control/floor';
import { distance } from './control/limit';
import { type Pose, readLink, writeLink } from './control/pose';
import { openContent } from './opened';
import type { Room } from './room';
import { createMeter } from './show/meter';
import { GRAPHICS_LOST, MAX_FRAME_SECONDS } from './show/renderer';
import { strategyOf } from './show/stage';
import { createViewer, type Viewer } from './show/viewer';
import { find } from './ui/dom';
import { clearMessage, FATAL, showFatal } from './ui/messages';
import { createDivider, createLoadingLine, createThumbMark } from './ui/overlays';
import { createPanel } from './ui/panel';
import type { Commands } from './ui/status';
import { type Headset, offerHeadset } from './xr/session';

/** Vertical field of view, degrees. */
const ANGLE = 75;
/** Seconds between two updates of the panel; timeout in seconds for loading the script of rooms. */
const [PANEL_INTERVAL, ROOM_TIMEOUT] = [0.25, 2] as const;

declare global {
  interface Window {
    /** Viewer and room for scripts and tests. */
    nearfar?: { readonly viewer: Viewer; readonly pose: Pose; readonly room: Room | null; setPose(pose: Pose): void };
  }
}

async function main(): Promise<void> {
  const query = new URLSearchParams(location.search);
  const [canvas, root] = [find('canvas', HTMLCanvasElement), find('#ui', HTMLElement)];
  const meter = createMeter();
  const base = new URL(query.get('bundle') ?? '.', location.href);
  const strategy = strategyOf(query.get('strategy'));
  const loadingLine = createLoadingLine(root);
  // The script of rooms is loaded in parallel with the manifest.
  const script = query.has('room') ? import('./room') : null;
  // Its failure is reported below, when there is a panel.
  script?.catch(() => {});
  const opened = await openContent(base, query, strategy, meter.receive, loadingLine.show)
    .finally(loadingLine.hide);
  meter.reset();
  const { centers, files, world } = opened;
  if (opened.title !== null) document.title = `${opened.title} – nearfar`;
  let headset: Headset | null = null;
  let room: Room | null = null;
  let problems: readonly string[] = [];
  /** Pose to which the user jumps, and the last one whose region could not be loaded. */
  let [targetPose, failedPose]: (Pose | null)[] = [null, null];
  const go = (target: Pose): void => {
    targetPose = target;
    viewer.go(target);
  };
  const retry = (): void => {
    // Some browsers restore lost graphics only when the page is reloaded.
    if (problems.includes(GRAPHICS_LOST)) {
      history.replaceState(null, '', writeLink(pose));
      location.reload();
      return;
    }
    problems = [];
    clearMessage();
    viewer.retry();
    if (failedPose) go(failedPose);
    failedPose = null;
  };
  const viewer = createViewer(canvas, {
    world,
    fetch: files.fetch,
    worker: new URL('worker.js', import.meta.url),
    angle: ANGLE,
    antialias: query.get('aa') !== '0',
    isSmooth: strategy.isSmooth,
    isWhole: strategy.isWhole,
    onFailure(reason) {
      problems = [reason.message];
      if (viewer.facts.goal === null) [targetPose, failedPose] = [null, targetPose];
      const file = damagedFile(reason);
      if (file !== null) files.distrust(file);
      // Before ring 0 is loaded, there is no picture to keep.
      if (viewer.facts.arrived < 0) showError(reason);
    },
    onLoss(isLost) {
      problems = isLost ? [GRAPHICS_LOST] : [];
      // A headset's session ends, because it cannot use the restored context.
      if (isLost && headset?.isPresenting) void headset.toggle();
    },
    onMove(pose) {
      // The user is elsewhere now, so that the failed jump no longer matters.
      if (failedPose) problems = [];
      targetPose = failedPose = null;
      controls.setPose(pose);
      headset?.place(pose);
    },
  });
  const homeOf = (number: number): Pose => ({ ...pose, position: world.places.spotOf(number).center });
  const start = readLink(location.hash) ?? opened.start;
  const thumb = createThumbMark(root);
  const controls = createControls(canvas, {
    start,
    onThumb: thumb.show,
    onGo(x, y) {
      const direction = directionTo(pose, [x, y], viewer.camera);
      go({ ...pose, position: destinationOf(pose.position, direction, viewer.pointAt(x, y)) });
    },
  });
  let pose = controls.update(0);
  window.nearfar = {
    viewer,
    setPose: controls.setPose,
    get pose() {
      return pose;
    },
    get room() {
      return room;
    },
  };
  window.addEventListener('hashchange', () => go(readLink(location.hash) ?? pose));
  const divider = createDivider(root, (share) => {
    viewer.setDivider(share);
    panel.updateButtons({ isDivided: share !== null });
  });
  const commands: Commands = {
    setDivider: divider.set,
    setMode: controls.setMode,
    home: () => go(homeOf(viewer.facts.region)),
    lookAround: controls.lookAround,
    screenshot: viewer.photo,
    link: () => new URL(writeLink(pose), location.href).href,
    retry,
  };
  if (centers && centers.length > 1) {
    commands.next = () => {
      const placeNumber = (world.places.nearest(pose.position) + 1) % centers.length;
      go(homeOf(placeNumber));
      panel.announce(`Place ${placeNumber + 1} of ${centers.length}`);
    };
  }
  const panel = createPanel(root, commands);
  const { isStatic } = opened;
  const headsetSettings = { pose: () => pose, bounds: () => viewer.facts.bounds, onLeave: controls.setPose, isStatic };
  offerHeadset(viewer, headsetSettings, (result) => {
    headset = typeof result === 'string' ? null : result;
    commands.headset = result;
  });
  if (script) {
    const hands = (): Headset['hands'] | null => (headset?.isPresenting ? headset.hands : null);
    const { announce, addHelp } = panel;
    const [movingFiles, nearShare] = [opened.movingFiles, world.nearShare];
    const host = { viewer, canvas, root, files, movingFiles, nearShare, hands, go, announce, addHelp };
    const entered = script.then(
      async ({ enter }) => {
        room = enter(host);
        if (room && query.get('task') === 'collect') (await import('./collect/start')).begin(room, host);
      },
      () => panel.announce('The script of rooms cannot be loaded; reload the page'),
    ).catch((reason) => panel.announce(`The room cannot be entered: ${reason}`));
    // Other users of the room may send the files of the first picture.
    await Promise.race([entered, new Promise((done) => setTimeout(done, 1000 * ROOM_TIMEOUT))]);
  }
  viewer.open(world.places.nearest(start.position));
  let lastTime = performance.now();
  let panelAge: number = PANEL_INTERVAL;
  viewer.renderer.setAnimationLoop((now: number) => {
    const seconds = Math.max(now - lastTime, 0) / 1000;
    lastTime = now;
    pose = headset?.update(Math.min(seconds, MAX_FRAME_SECONDS)) ?? controls.update(seconds);
    room?.frame(pose);
    viewer.frame(pose, Math.min(seconds, MAX_FRAME_SECONDS));
    controls.setBounds(viewer.facts.bounds);
    meter.frame(seconds);
    panelAge += seconds;
    if (panelAge < PANEL_INTERVAL) return;
    panelAge = 0;
    const { shown, triangles, region, entry, goal, received, expected } = viewer.facts;
    const { center, fold_margin } = world.places.spotOf(region);
    const rings = ringsOf(entry);
    panel.update({
      ring: Math.min(shown?.ring ?? 0, rings),
      rings,
      isSharp: entry !== null && (!entry.isCoarse || (shown?.ring ?? 0) > rings),
      serverProgress: opened.progressOf(goal ?? region),
      radius: shown?.grown.radius ?? 0,
      ...meter.read(),
      received,
      expected,
      triangles: triangles.inFile,
      drawn: triangles.drawn,
      sceneTriangles: opened.triangles,
      region,
      regions: centers?.length ?? null,
      distance: distance(pose.position, { center, metres: fold_margin }),
      foldMargin: fold_margin,
      problems,
    });
  });
}

/** Returns the number of a region's rings; a last ring that only has sharper maps does not count. */
function ringsOf(entry: RegionEntry | null): number {
  return (entry?.rings.length ?? 1) - 1 - (entry?.isCoarse ? 1 : 0);
}

function showError(reason: unknown): void {
  const detail = messageOf(reason);
  const { title, text } = FATAL[reason instanceof BundleError ? reason.kind : 'other'];
  showFatal(title, text, { detail, retry: () => location.reload() });
}

main().catch(showError);
