/** Headset: finds one, draws the picture for both eyes, and moves its user. */
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
import { createHandVisuals, type HandVisuals } from './hand_visuals';
import { createHands, type HandRay } from './hands';
import { createSteering, type Input, readInputs, type Steering } from './inputs';
import { createMapLayer } from './layer';
import { createAiming, createJump, type Jump } from './teleport';

export type Headset = ReturnType<typeof createHeadset>;

export interface HeadsetSettings {
  /** Returns the user's pose at the beginning of a session. */
  readonly pose: () => Pose;
  /** Returns the area where the user may be; called in every frame. */
  readonly bounds: () => Bounds | null;
  /** Called after the end of a session, with the pose for the screen. */
  readonly onLeave: (pose: Pose) => void;
  /** Whether nothing moves in the scene, so that a composition layer may show the map. */
  readonly isStatic: boolean;
}

interface SessionState {
  readonly visuals: HandVisuals;
  readonly aim: ReturnType<typeof createAiming>;
  readonly findHands: ReturnType<typeof createHands>;
  /** Removes the listeners of the session. */
  readonly stop: AbortController;
  readonly steer: Steering;
  readonly jump: Jump;
  readonly walk: ReturnType<typeof createWalk>;
  /** Floor of the user; null before the headset is tracked. */
  floor: Floor | null;
  pose: Pose;
  /** World point to which the user jumps in this frame; null for none. */
  goal: Vector | null;
  /** Whether the system has moved the origin of the headset's space since the last frame. */
  isOriginMoved: boolean;
}

/** In a headset, no movement starts or stops suddenly. */
const isSudden = (): boolean => false;

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
    rig.add(newState.visuals.group);
    renderer.xr.getReferenceSpace()?.addEventListener('reset', () => (newState.isOriginMoved = true));
    if (settings.isStatic) viewer.setMapLayer(createMapLayer(renderer, viewer.faceSize));
  }

  function begin(session: XRSession): SessionState {
    const [pose, stop] = [settings.pose(), new AbortController()];
    const newState: SessionState = {
      visuals: createHandVisuals(),
      aim: createAiming(session, stop.signal, (target) => {
        const { floor, jump } = newState;
        const goal = floor && worldOf(floor, target);
        jump.start(() => (newState.goal = goal));
      }),
      findHands: createHands(session, stop.signal),
      stop,
      steer: createSteering(),
      jump: createJump(),
      walk: createWalk(pose, () => bounds, isSudden),
      floor: null,
      pose,
      goal: null,
      isOriginMoved: false,
    };
    return newState;
  }

  function leave(): void {
    if (!state) return;
    const { visuals, stop, floor, pose } = state;
    state = null;
    hands = [];
    stop.abort();
    visuals.dispose();
    viewer.setMapLayer(null);
    viewer.setVeil(0);
    const [x, y, z] = pose.position;
    settings.onLeave({ position: [x, floor ? floor.position[1] + EYE_HEIGHT : y, z], yaw: pose.yaw, pitch: 0 });
  }

  /** Returns the floor after the user has walked, turned or jumped in a frame, within the bounds. */
  function floorOf(session: SessionState, head: Head, inputs: readonly Input[], seconds: number): Floor {
    const { position: [x, y, z], yaw } = session.pose;
    const ground: Vector = [x, session.floor?.position[1] ?? y - EYE_HEIGHT, z];
    let floor = session.floor && !session.isOriginMoved ? session.floor : floorUnder(ground, yaw, head);
    session.isOriginMoved = false;
    const { drive, turn } = session.steer(stickOf(inputs, 'left'), stickOf(inputs, 'right'));
    if (turn !== 0) floor = turnFloor(floor, head, turn);
    session.walk.follow(worldPose(floor, head));
    session.walk.update(seconds, drive);
    floor = moveFloor(floor, head, session.goal ?? session.walk.pose.position);
    session.goal = null;
    // If the user's head leaves the bounds, the floor moves so that the head is inside.
    return moveFloor(floor, head, clampToBounds(worldOf(floor, head.position), bounds));
  }

  return {
    get isPresenting(): boolean {
      return state !== null;
    },
    get hands(): readonly HandRay[] {
      return hands;
    },
    /** Enters or leaves the headset; browsers allow this only after a click or a key. */
    toggle(): Promise<void> {
      const session = renderer.xr.getSession();
      return session ? session.end() : enter();
    },
    /** Moves the user to another pose, if there is a session. */
    place(pose: Pose): void {
      if (state) Object.assign(state, { floor: null, pose });
    },
    /** Moves the user, some seconds after the last frame; returns the head's world pose, null without a session. */
    update(seconds: number): Pose | null {
      const [frame, space] = [renderer.xr.getFrame(), renderer.xr.getReferenceSpace()];
      if (!state || !frame || !space) return null;
      const viewerPose = frame.getViewerPose(space);
      // While the headset is not tracked, the pose stays.
      if (!viewerPose) return state.pose;
      bounds = headBounds(settings.bounds());
      const head = headOf(viewerPose.transform.matrix);
      const inputs = readInputs(frame, space);
      viewer.setVeil(state.jump.advance(seconds));
      const floor = floorOf(state, head, inputs, seconds);
      state.floor = floor;
      state.pose = worldPose(floor, head);
      viewer.setFloor(floor);
      hands = state.findHands(inputs, floor);
      const clamp = (point: Vector): Vector => localOf(floor, clampToBounds(worldOf(floor, point), bounds));
      state.visuals.update(inputs, state.aim(inputs, clamp));
      return state.pose;
    },
  };
}

function stickOf(inputs: readonly Input[], hand: XRHandedness): Input['stick'] {
  return inputs.find(({ source }) => source.handedness === hand)?.stick ?? null;
}

/** Calls `report` with the headset, or with a sentence why there is none, now and after each change. */
export function offerHeadset(viewer: Viewer, settings: HeadsetSettings, report: (found: Headset | string) => void): void {
  const { xr } = navigator;
  let headset: Headset | null = null;

  async function findHeadset(): Promise<void> {
    const reason = await reasonForNoHeadset(xr, window.isSecureContext);
    if (reason === null && xr) headset ??= createHeadset(viewer, xr, settings);
    report(reason ?? headset ?? '');
  }

  void findHeadset();
  xr?.addEventListener('devicechange', () => void findHeadset());
}

/** Returns a sentence why there is no headset to enter; null if there is one. */
export async function reasonForNoHeadset(xr: XRSystem | undefined, isSecure: boolean): Promise<string | null> {
  if (!isSecure) return 'Headsets need a page that is served over https.';
  if (!xr) return 'This browser does not support headsets.';
  try {
    return (await xr.isSessionSupported('immersive-vr')) ? null : 'No headset is connected.';
  } catch {
    // The page is in an iframe without permission for headsets.
    return 'This page may not use headsets.';
  }
}
