/** View in a notebook, which anywidget creates: a canvas with a line of text below it. */
import { messageOf } from '../base/errors';
import type { Source } from '../bundle/source';
import { createControls } from '../control/controls';
import type { Pose } from '../control/pose';
import { MAX_FRAME_SECONDS, GRAPHICS_LOST } from '../show/renderer';
import { strategyOf } from '../show/stage';
import { createViewer, type Viewer } from '../show/viewer';
import { worldOf } from '../show/world';
import { type KernelSource, openKernel } from './kernel';
import { createMirror, type Model } from './model';

const POSE = ['position', 'yaw', 'pitch'] as const;

/** Element of a view; scripts and tests find the viewer in it. */
interface Host extends HTMLElement {
  nearfar?: { readonly viewer: Viewer };
}

type View = ReturnType<typeof createView>;

/**
 * Creates the widget; `worker` is the script of the workers. Anywidget calls `render` with a model and an element for a
 * view, and ends the view by the function that `render` returns.
 */
export function createWidget(worker: URL) {
  return { render: ({ model, el }: { model: Model; el: HTMLElement }) => render(model, el, worker) };
}

function render(model: Model, el: HTMLElement, worker: URL): () => void {
  const view = createView(model, el);
  const stop = new AbortController();
  let source: KernelSource | null = null;
  let end = (): void => undefined;
  const onFailure = (reason: unknown): void => {
    if (stop.signal.aborted) return;
    const problem = messageOf(reason);
    view.setProblem(problem);
    model.set('problem', problem);
    model.save_changes();
  };
  openKernel(model, () => undefined, stop.signal)
    .then((opened) => {
      source = opened;
      if (stop.signal.aborted) opened.dispose();
      else end = show(model, view, opened, worker, onFailure);
    })
    .catch(onFailure);
  return () => {
    stop.abort(new Error('the view was removed'));
    source?.dispose();
    end();
    view.host.remove();
  };
}

function createView(model: Model, el: HTMLElement) {
  const host: Host = document.createElement('div');
  const [canvas, text] = [document.createElement('canvas'), document.createElement('p')];
  host.className = 'nearfar-view';
  // JupyterLab must not take the keys of the view as its shortcuts.
  host.dataset['lmSuppressShortcuts'] = 'true';
  canvas.tabIndex = 0;
  canvas.setAttribute('aria-label', '3D view: drag to look, W A S D and arrows to walk');
  canvas.style.width = `${model.get('width')}px`;
  canvas.style.aspectRatio = `${model.get('width')} / ${model.get('height')}`;
  text.setAttribute('role', 'status');
  text.textContent = 'Loading…';
  host.append(canvas, text);
  el.append(host);
  let problem = '';
  /** Shows a line below the picture, or the problem if there is one. */
  const showText = (line: string): void => {
    if (text.textContent !== (problem || line)) text.textContent = problem || line;
  };
  return { host, canvas, showText, setProblem: (newProblem: string): void => showText((problem = newProblem)) };
}

/** Draws frames until the returned function is called. */
function show(model: Model, view: View, source: Source, worker: URL, onFailure: (reason: Error) => void): () => void {
  const { canvas, host } = view;
  const { arrange, isSmooth, isWhole } = strategyOf(String(model.get('strategy')));
  const world = worldOf(arrange(source.manifest));
  const requestedPose = (): Pose => Object.fromEntries(POSE.map((name) => [name, model.get(name)])) as unknown as Pose;
  const controls = createControls(canvas, { start: requestedPose(), keys: canvas });
  const viewer = createViewer(canvas, {
    world,
    fetch: source.fetch,
    worker,
    angle: Number(model.get('angle')),
    antialias: true,
    isSmooth,
    isWhole,
    onFailure,
    onLoss: (isLost) => view.setProblem(isLost ? GRAPHICS_LOST : ''),
    onMove: controls.setPose,
  });
  host.nearfar = { viewer };
  const mirror = createMirror(model);
  mirror.listen(POSE, () => {
    const target = requestedPose();
    if (world.places.nearest(target.position) === viewer.facts.region) controls.setPose(target);
    else viewer.go(target);
  });
  mirror.listen(['angle'], () => {
    viewer.camera.fov = Number(model.get('angle'));
    viewer.camera.updateProjectionMatrix();
  });
  viewer.open(world.places.nearest(requestedPose().position));
  let isOnScreen = true;
  // A view is not drawn while it is scrolled out of the screen.
  const watch = new IntersectionObserver((entries) => {
    isOnScreen = entries.at(-1)?.isIntersecting ?? true;
  });
  watch.observe(canvas);
  let last = performance.now();
  viewer.renderer.setAnimationLoop((now: number) => {
    const seconds = Math.max(now - last, 0) / 1000;
    last = now;
    if (!isOnScreen) return;
    const pose = controls.update(seconds);
    viewer.frame(pose, Math.min(seconds, MAX_FRAME_SECONDS));
    const { bounds, shown, region, entry, goal, arrived } = viewer.facts;
    controls.setBounds(bounds);
    const rings = (entry?.rings.length ?? 1) - 1;
    if (arrived >= 0) view.showText(arrived < rings ? `Ring ${arrived} of ${rings}` : '');
    const { radius, strength } = shown?.grown ?? { radius: 0, strength: 0 };
    const state = { region, ring: shown?.ring ?? -1, radius, strength };
    // During a jump, Python already has the target's pose.
    mirror.send(goal === null ? { ...pose, ...state } : state, now);
  });
  return () => {
    viewer.renderer.setAnimationLoop(null);
    watch.disconnect();
    mirror.dispose();
    controls.dispose();
    viewer.dispose();
  };
}
