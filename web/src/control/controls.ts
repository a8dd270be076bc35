/** How the user moves: walking or going around a point, with keys, mouse, touch and gamepads. */
import { type Drive, together } from './drive';
import { type Pad, readPads } from './gamepad';
import { createKeys } from './keys';
import type { Bounds } from './limit';
import { createOrbit } from './orbit';
import { createPointers, type Mode, type Thumb } from './pointers';
import type { Pose } from './pose';
import { isSamePose } from './vector';
import { createWalk } from './walk';

export type { Mode, Thumb };

/** Longest time that one update stands for, seconds: a tab that was hidden goes on where it was. */
const LONGEST = 0.5;

export interface ControlSettings {
  /** Where the user begins; its height is the eye height. */
  readonly start: Pose;
  /** The pose is another one than after the update before. */
  readonly onChange?: (pose: Pose) => void;
  /** The left thumb walks: where it is, or null when it is gone. */
  readonly onThumb?: (thumb: Thumb | null) => void;
  /** Two taps or clicks ask for a place, in parts of the picture's width and height from its upper left. */
  readonly onGo?: (x: number, y: number) => void;
  /** The target that hears keys: the window by default; in a notebook the element, so that the notebook keeps its own keys. */
  readonly keys?: EventTarget;
  /** Gamepads, by default those of the browser. */
  readonly pads?: () => readonly (Pad | null)[];
  /** Start and stop at once instead of gliding; by default as the system asks for reduced motion. */
  readonly isSudden?: () => boolean;
}

export interface Controls {
  /** The pose after some seconds more. Call it once a frame. */
  update(seconds: number): Pose;
  readonly mode: Mode;
  /** Walk, or go around a point; the pose stays. */
  setMode(mode: Mode): void;
  /** Stand somewhere else at once. */
  setPose(pose: Pose): void;
  /** A walker looks around with the mouse without a button, until Escape. */
  lookAround(): void;
  /** Stay within bounds; null lifts them. */
  setBounds(bounds: Bounds | null): void;
  dispose(): void;
}

/** Let an element, which should be focusable, steer a pose. */
export function createControls(element: HTMLElement, settings: ControlSettings): Controls {
  const { start, onChange, onThumb, onGo, pads = browserPads, isSudden = reducedMotion() } = settings;
  let mode: Mode = 'walk';
  let bounds: Bounds | null = null;
  let last = start;
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

  const current = (): Pose => (mode === 'walk' ? walk.pose : orbit.pose);

  return {
    update(seconds) {
      const wishes: Drive = together(keys.drive, pointers.drive, readPads(pads()));
      // NaN fails every comparison, so that it counts as no time.
      const spent = seconds > 0 ? Math.min(seconds, LONGEST) : 0;
      if (mode === 'walk') walk.update(spent, wishes);
      else orbit.update(spent, wishes);
      const pose = current();
      if (!isSamePose(pose, last)) onChange?.(pose);
      last = pose;
      return pose;
    },
    get mode() {
      return mode;
    },
    setMode(next) {
      if (next === mode) return;
      const pose = current();
      pointers.release();
      mode = next;
      if (mode === 'walk') walk.resume(pose);
      else orbit.setPose(pose);
    },
    setPose(pose) {
      walk.setPose(pose);
      orbit.setPose(pose);
    },
    lookAround: pointers.lock,
    setBounds(next) {
      bounds = next;
    },
    dispose() {
      keys.dispose();
      pointers.dispose();
    },
  };
}

function browserPads(): readonly (Pad | null)[] {
  // Pages without https or with a policy against gamepads have none.
  try {
    return navigator.getGamepads?.() ?? [];
  } catch {
    return [];
  }
}

function reducedMotion(): () => boolean {
  const query = window.matchMedia('(prefers-reduced-motion: reduce)');
  return () => query.matches;
}
