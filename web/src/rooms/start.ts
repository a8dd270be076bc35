/** A room in the page: who is here, where they look and point. A script of its own, for those who join a room. */
import type { Pose } from '../control/pose';
import type { Vector } from '../control/vector';
import type { Guests } from '../show/picture';
import type { Viewer } from '../show/viewer';
import { make } from '../ui/dom';
import type { HandRay } from '../xr/hands';
import { type Address, inviteOf, readAddress } from './address';
import { NOTHING_HIT, targetAt } from './aim';
import { type Avatars, createAvatars } from './avatars';
import { connect, type Connection } from './connection';
import type { FromServer } from './frames';
import { createHere, type HereCommands } from './here';
import { createHold, type Hold, type Place } from './hold';
import { atScreen, inHeadset } from './own';
import { type Body, isWithin } from './pose';
import { createPresence, type Presence, type Seen } from './presence';
import { createSender } from './sending';

/** Seconds between two looks at what the pointer hits, and between two updates of the card. */
const [AIM_EVERY, CARD_EVERY] = [1 / 36, 0.25] as const;

/** The tangent of the angle that a pixel of a headset covers: some twenty are in a degree. */
const HEADSET_PIXEL = 9e-4;

/** The page, as far as a room uses it. */
export interface Host {
  readonly viewer: Viewer;
  readonly canvas: HTMLCanvasElement;
  readonly root: HTMLElement;
  /** r1 as a share of r2. */
  readonly nearShare: number;
  /** The hands of the headset; null outside. */
  hands(): readonly HandRay[] | null;
  /** Go to another place, as soon as it can be shown. */
  go(pose: Pose): void;
  announce(text: string): void;
}

/** What users of a room do together; it draws what guests are drawn as. */
export interface Activity extends Guests {
  /** Whether users point also while they hold nothing down. */
  readonly isPointing: boolean;
  /** A frame of the server has come. */
  heard(frame: FromServer, now: number): void;
  /** Before each frame: where the user's eyes are, and what others see of it. */
  frame(pose: Pose, body: Body, now: number): void;
  /** The point of the world at which a part of the picture points; null for what the scene has there. */
  targetAt(pose: Pose, place: Place): Vector | null;
}

export interface Room {
  readonly address: Address;
  readonly connection: Connection;
  readonly presence: Presence;
  readonly avatars: Avatars;
  /** Others as they were drawn last, and the user's own body. */
  readonly seen: readonly Seen[];
  readonly body: Body | null;
  /** Before each frame: where the user is. */
  frame(pose: Pose): void;
  /** What users do together; null for nothing. */
  readonly activity: Activity | null;
  /** Let users do something together from now on. */
  begin(activity: Activity): void;
}

/** Join the room that the address of the page names; null where it names none that there can be. */
export function enter(host: Host): Room | null {
  document.head.append(make('link', { rel: 'stylesheet', href: new URL('rooms.css', import.meta.url).href }));
  const address = readAddress(new URLSearchParams(location.search));
  const commands: HereCommands = {
    mute: (number, isMuted) => room?.presence.mute(number, isMuted),
    retry: () => room?.connection.retry(),
    link: () => inviteOf(location.href),
    announce: host.announce,
  };
  const here = createHere(host.root, commands);
  if (typeof address === 'string') {
    here.refuse(address);
    return null;
  }
  const hold = createHold(host.canvas, here.button);
  const room = join(host, address, hold, (made) => {
    const { presence, connection } = made;
    const { name, group } = address;
    here.update(connection.state, { name, group, guests: presence.guests, roundTrip: connection.roundTrips.median });
  });
  return room;
}

/** `told` is called a few times a second. */
function join(host: Host, address: Address, hold: Hold, told: (room: Room) => void): Room {
  const { viewer, nearShare } = host;
  const presence = createPresence();
  const avatars = createAvatars(viewer.shared);
  const connection = connect({
    address,
    page: location.href,
    heard,
    changed: ({ kind }) => {
      if (kind !== 'here') presence.clear();
    },
  });
  const sender = createSender((body, stops) => {
    // Beyond it no frame can say where the user is.
    const isSendable = [body.head, body.left, body.right].every((placed) => !placed || isWithin(placed.position));
    return isSendable && connection.pose(body, stops);
  });
  const aim = createAim((pose, place) => activity?.targetAt(pose, place) ?? targetAt(viewer, nearShare, pose, place));
  let [seen, body]: [readonly Seen[], Body | null] = [[], null];
  let toldAt = -Infinity;
  /** Others who were there before the user. */
  let known = 0;
  let activity: Activity | null = null;
  viewer.setGuests(avatars);
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) sender.rest();
  });

  function heard(frame: FromServer, now: number): void {
    presence.hear(frame, now);
    if (frame.kind === 'welcome') known = frame.others;
    if (frame.kind === 'welcome' || frame.kind === 'joined') sender.repeat();
    if (frame.kind === 'joined' && --known < 0) host.announce(`${frame.name} is here`);
    activity?.heard(frame, now);
  }

  function bodyOf(pose: Pose, now: number): Body {
    const hands = host.hands();
    hold.isAlways = activity?.isPointing ?? false;
    const lengthOf = ({ origin, direction }: HandRay): number => viewer.along(origin, direction) ?? NOTHING_HIT;
    if (hands) return inHeadset(pose, hands, hold.isAlways, lengthOf);
    return atScreen(pose, aim(pose, hold.place, now));
  }

  const room: Room = {
    address,
    connection,
    presence,
    avatars,
    get seen() {
      return seen;
    },
    get body() {
      return body;
    },
    frame(pose) {
      const now = performance.now() / 1000;
      body = bodyOf(pose, now);
      sender.update(body, now);
      activity?.frame(pose, body, now);
      seen = presence.at(now);
      const { state } = connection;
      const own = state.kind === 'here' && body.pointer ? { number: state.user, body } : null;
      avatars.show(seen, own, pixelOf(viewer));
      if (now - toldAt < CARD_EVERY) return;
      toldAt = now;
      told(room);
    },
    get activity() {
      return activity;
    },
    begin(next) {
      activity = next;
      viewer.setGuests({
        get meshes() {
          return [...avatars.meshes, ...next.meshes];
        },
        place(center) {
          avatars.place(center);
          next.place(center);
        },
      });
    },
  };
  return room;
}

/** The tangent of the angle that a pixel covers in the middle of the picture. */
function pixelOf({ camera, renderer }: Viewer): number {
  if (renderer.xr.isPresenting) return HEADSET_PIXEL;
  return (2 * Math.tan((camera.fov * Math.PI) / 360)) / Math.max(renderer.domElement.height, 1);
}

type Aim = (pose: Pose, place: Place | null, now: number) => Vector | null;

/** Looks at what the pointer hits less often than frames are drawn: the answer of the GPU must be waited for. */
function createAim(look: (pose: Pose, place: Place) => Vector): Aim {
  let [target, next]: [Vector | null, number] = [null, -Infinity];
  return (pose, place, now) => {
    if (!place) {
      target = null;
      return null;
    }
    if (target && now < next) return target;
    next = now + AIM_EVERY;
    target = look(pose, place);
    return target;
  };
}
