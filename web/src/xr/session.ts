/** Immersive session: detection of a headset, the picture for both eyes, and the movement of its user. */
import {
  clampToBounds,
  EYE_HEIGHT,
  type Floor,
  floorUnder,
  type Head,
  headBounds,
  headOf,
  localOf,
  moveFloor,
  turnFloor,
  worldOf,
  worldPose,
} from '../control/floor';
import type { Bounds } from '../control/limit';
import type { Pose, Vector } from '../control/pose';
import { createWalk } from '../control/walk';
import type { Viewer } from '../show/viewer';
import { createHands, type HandRay } from './hands';
import { createSteering, type Input, readInputs, type Steering } from './inputs';
import { createMapLayer } from './layer';
import { createLook, type Look } from './look';
import { createAiming, createJump, type Jump } from './teleport';

export type Headset = ReturnType<typeof createHeadset>;

export interface HeadsetSettings {
  /** Returns the user's pose at the begin of a session. */
  readonly pose: () => Pose;
  /** Returns the area in which the eyes stay, also when it changes. */
  readonly bounds: () => Bounds | null;
  /** Called after the end of a session, with a pose for the screen. */
  readonly left: (pose: Pose) => void;
  /** Whether nothing moves, so that the browser may show the map in a composition layer. */
  readonly isStatic: boolean;
}

interface SessionState {
  readonly look: Look;
  readonly aim: ReturnType<typeof createAiming>;
  readonly findHands: ReturnType<typeof createHands>;
  /** Ends listening to the session. */
  readonly stop: AbortController;
  readonly steer: Steering;
  readonly jump: Jump;
  readonly walk: ReturnType<typeof createWalk>;
  /** Floor of the user; null until the headset is tracked. */
  floor: Floor | null;
  pose: Pose;
  /** World point to which a jump leads in this frame. */
  goal: Vector | null;
  /** Whether the system has moved the origin of the headset's space. */
  isMoved: boolean;
}

/** Speeds start and stop gently. */
const neverSudden = (): boolean => false;

function createHeadset(viewer: Viewer, xr: XRSystem, settings: HeadsetSettings) {
  const { renderer, rig } = viewer;
  let bounds: Bounds | null = null;
  let state: SessionState | null = null;
  let hands: readonly HandRay[] = [];
  renderer.xr.enabled = true;

  async function enter(): Promise<void> {
    const session = await xr.requestSession('immersive-vr', {
      requiredFeatures: ['local-floor'],
      optionalFeatures: ['hand-tracking', 'layers'],
    });
    session.addEventListener('end', leave);
    try {
      await renderer.xr.setSession(session);
    } catch (reason) {
      await session.end();
      throw reason;
    }
    const newState = begin(session);
    state = newState;
    rig.add(newState.look.group);
    renderer.xr.getReferenceSpace()?.addEventListener('reset', () => (newState.isMoved = true));
    if (settings.isStatic) viewer.setMapLayer(createMapLayer(renderer, viewer.faceSize));
  }

  function begin(session: XRSession): SessionState {
    const [pose, stop] = [settings.pose(), new AbortController()];
    const newState: SessionState = {
      look: createLook(),
      aim: createAiming(session, stop.signal, (target) => {
        const { floor, jump } = newState;
        const goal = floor && worldOf(floor, target);
        jump.start(() => (newState.goal = goal));
      }),
      findHands: createHands(session, stop.signal),
      stop,
      steer: createSteering(),
      jump: createJump(),
      walk: createWalk(pose, () => bounds, neverSudden),
      floor: null,
      pose,
      goal: null,
      isMoved: false,
    };
    return newState;
  }

  function leave(): void {
    if (!state) return;
    const { look, stop, floor, pose } = state;
    state = null;
    hands = [];
    stop.abort();
    look.dispose();
    viewer.setMapLayer(null);
    viewer.setVeil(0);
    const [x, y, z] = pose.position;
    settings.left({ position: [x, floor ? floor.position[1] + EYE_HEIGHT : y, z], yaw: pose.yaw, pitch: 0 });
  }

  /** Returns the floor after a frame: the user has walked, turned or jumped, and stays within the bounds. */
  function floorOf(session: SessionState, head: Head, inputs: readonly Input[], seconds: number): Floor {
    const { position: [x, y, z], yaw } = session.pose;
    const ground: Vector = [x, session.floor?.position[1] ?? y - EYE_HEIGHT, z];
    let floor = session.floor && !session.isMoved ? session.floor : floorUnder(ground, yaw, head);
    session.isMoved = false;
    const { drive, turn } = session.steer(stickOf(inputs, 'left'), stickOf(inputs, 'right'));
    if (turn !== 0) floor = turnFloor(floor, head, turn);
    session.walk.follow(worldPose(floor, head));
    session.walk.update(seconds, drive);
    floor = moveFloor(floor, head, session.goal ?? session.walk.pose.position);
    session.goal = null;
    // A body that moves beyond the bounds drags the floor along.
    return moveFloor(floor, head, clampToBounds(worldOf(floor, head.position), bounds));
  }

  return {
    get isPresenting(): boolean {
      return state !== null;
    },
    get hands(): readonly HandRay[] {
      return hands;
    },
    /** Enters or leaves the session; browsers require a click or a key. */
    toggle(): Promise<void> {
      const session = renderer.xr.getSession();
      return session ? session.end() : enter();
    },
    /** Moves the user's head above another place; without effect outside a session. */
    place(pose: Pose): void {
      if (state) Object.assign(state, { floor: null, pose });
    },
    /** Advances by some seconds, once per frame; returns the head's world pose, null outside a session. */
    update(seconds: number): Pose | null {
      const [frame, space] = [renderer.xr.getFrame(), renderer.xr.getReferenceSpace()];
      if (!state || !frame || !space) return null;
      const viewerPose = frame.getViewerPose(space);
      // Without tracking the pose does not change.
      if (!viewerPose) return state.pose;
      bounds = headBounds(settings.bounds());
      const head = headOf(viewerPose.transform.matrix);
      const inputs = readInputs(frame, space);
      viewer.setVeil(state.jump.advance(seconds));
      const floor = floorOf(state, head, inputs, seconds);
      state.floor = floor;
      state.pose = worldPose(floor, head);
      viewer.stand(floor);
      hands = state.findHands(inputs, floor);
      const allowed = (point: Vector): Vector => localOf(floor, clampToBounds(worldOf(floor, point), bounds));
      state.look.update(inputs, state.aim(inputs, allowed));
      return state.pose;
    },
  };
}

function stickOf(inputs: readonly Input[], hand: XRHandedness): Input['stick'] {
  return inputs.find(({ source }) => source.handedness === hand)?.stick ?? null;
}

/** Detects the headset; `tell` is called with it, or with a sentence why there is none, now and on changes. */
export function offerHeadset(viewer: Viewer, settings: HeadsetSettings, report: (found: Headset | string) => void): void {
  const { xr } = navigator;
  let headset: Headset | null = null;

  async function seek(): Promise<void> {
    const reason = await whyNoHeadset(xr, window.isSecureContext);
    if (reason === null && xr) headset ??= createHeadset(viewer, xr, settings);
    report(reason ?? headset ?? '');
  }

  void seek();
  xr?.addEventListener('devicechange', () => void seek());
}

/** Returns why no headset can be entered; null if one can. */
export async function whyNoHeadset(xr: XRSystem | undefined, isSecure: boolean): Promise<string | null> {
  if (!isSecure) return 'Headsets need a page that is served over https.';
  if (!xr) return 'This browser does not support headsets.';
  try {
    return (await xr.isSessionSupported('immersive-vr')) ? null : 'No headset is connected.';
  } catch {
    // The page is in a frame without permission for headsets.
    return 'This page may not use headsets.';
  }
}
