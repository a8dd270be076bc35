/** User movement: walking or orbiting a point, by keyboard, mouse, touch and gamepads. */
import { browserPads, combine, createKeys, type Drive, type Pad, readPads } from './drive';
import type { Bounds } from './limit';
import { createOrbit } from './orbit';
import { createPointers, type Mode, type Thumb } from './pointers';
import { isSamePose, type Pose } from './pose';
import { createWalk } from './walk';

/** Greatest time per update, seconds: the pose does not jump when a hidden page is shown again. */
const MAX_SECONDS = 0.5;

export interface ControlSettings {
  /** Start pose; its height is the eye height. */
  readonly start: Pose;
  /** Called when the pose has changed since the last update. */
  readonly onChange?: (pose: Pose) => void;
  /** Called with the position of the left thumb, which controls walking; null when it is lifted. */
  readonly onThumb?: (thumb: Thumb | null) => void;
  /** Called on a double tap or double click; x and y are shares of the width and height, from the upper left. */
  readonly onGo?: (x: number, y: number) => void;
  /** Target of key events: the window by default; in a notebook the element, so that the notebook keeps its keys. */
  readonly keys?: EventTarget;
  /** Gamepads; the browser's by default. */
  readonly pads?: () => readonly (Pad | null)[];
  /** Whether movement starts and stops abruptly; by default the system's setting for reduced motion. */
  readonly isSudden?: () => boolean;
}

export type Controls = ReturnType<typeof createControls>;

/** Controls a pose by input on an element, which should be focusable. */
export function createControls(element: HTMLElement, settings: ControlSettings) {
  const { start, onChange, onThumb, onGo, pads = browserPads, isSudden = watchReducedMotion() } = settings;
  let mode: Mode = 'walk';
  let bounds: Bounds | null = null;
  let lastPose = start;
  const walk = createWalk(start, () => bounds, isSudden);
  const orbit = createOrbit(start, () => bounds);
  const keys = createKeys(settings.keys ?? window);
  const pointers = createPointers(element, {
    mode: () => mode,
    look: walk.look,
    rotate: orbit.rotate,
    pan: orbit.pan,
    zoom: orbit.zoom,
    thumb: (thumb) => onThumb?.(thumb),
    go: (x, y) => onGo?.(x, y),
  });

  const currentPose = (): Pose => (mode === 'walk' ? walk.pose : orbit.pose);

  return {
    /** Advances by some seconds and returns the pose; called once per frame. */
    update(seconds: number): Pose {
      const drive: Drive = combine(keys.drive, pointers.drive, readPads(pads()));
      // NaN fails every comparison and counts as zero.
      const elapsed = seconds > 0 ? Math.min(seconds, MAX_SECONDS) : 0;
      if (mode === 'walk') walk.update(elapsed, drive);
      else orbit.update(elapsed, drive);
      const pose = currentPose();
      if (!isSamePose(pose, lastPose)) onChange?.(pose);
      lastPose = pose;
      return pose;
    },
    get mode(): Mode {
      return mode;
    },
    /** Switches between walking and orbiting; the pose does not change. */
    setMode(next: Mode): void {
      if (next === mode) return;
      const pose = currentPose();
      pointers.release();
      mode = next;
      if (mode === 'walk') walk.resume(pose);
      else orbit.setPose(pose);
    },
    /** Moves the user at once. */
    setPose(pose: Pose): void {
      walk.setPose(pose);
      orbit.setPose(pose);
    },
    /** Locks the mouse pointer, so that a walker looks around without a button, until Escape. */
    lookAround: pointers.lock,
    /** Keeps the user within bounds; null removes them. */
    setBounds(next: Bounds | null): void {
      bounds = next;
    },
    dispose(): void {
      keys.dispose();
      pointers.dispose();
    },
  };
}

function watchReducedMotion(): () => boolean {
  const query = window.matchMedia('(prefers-reduced-motion: reduce)');
  return () => query.matches;
}
