/** A room in the page: who is here, where they look and point. A script of its own, for those who join a room. */
import { filesOfRing } from '../bundle/contents';
import type { Files } from '../bundle/source';
import type { Pose } from '../control/pose';
import type { Vector } from '../control/vector';
import { type Peers, startPeers } from '../peers/start';
import type { Viewer } from '../show/viewer';
import { make } from '../ui/dom';
import type { HandRay } from '../xr/hands';
import { askOnce } from './about';
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
import { createOpen } from './way';

/** Seconds between two looks at what the pointer hits, and between two updates of the card. */
const [AIM_EVERY, CARD_EVERY] = [1 / 36, 0.25] as const;

/** The tangent of the angle that a pixel of a headset covers: some twenty are in a degree. */
const HEADSET_PIXEL = 9e-4;

/** The page, as far as a room uses it. */
export interface Host {
  readonly viewer: Viewer;
  readonly canvas: HTMLCanvasElement;
  readonly root: HTMLElement;
  readonly files: Files;
  /** Files that every region needs. */
  readonly moving: readonly string[];
  /** r1 as a share of r2. */
  readonly nearShare: number;
  /** The hands of the headset; null outside. */
  hands(): readonly HandRay[] | null;
  announce(text: string): void;
}

export interface Room {
  readonly connection: Connection;
  readonly presence: Presence;
  readonly avatars: Avatars;
  /** The exchange of files with others. */
  readonly peers: Peers;
  /** Others as they were drawn last, and the user's own body. */
  readonly seen: readonly Seen[];
  readonly body: Body | null;
  /** Before each frame: where the user is. */
  frame(pose: Pose): void;
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
    const { presence, connection, peers } = made;
    const { name, group } = address;
    const { others, server } = peers.counts;
    const files = peers.refusal === null ? { others: others.bytes, server: server.bytes } : null;
    const roundTrip = connection.roundTrips.median;
    here.update(connection.state, { name, group, guests: presence.guests, roundTrip, files });
  });
  return room;
}

/** `told` is called a few times a second. */
function join(host: Host, address: Address, hold: Hold, told: (room: Room) => void): Room {
  const { viewer, nearShare } = host;
  const presence = createPresence();
  const avatars = createAvatars(viewer.shared);
  const isWithoutDatagrams = new URLSearchParams(location.search).get('datagrams') === 'off';
  const ask = askOnce(location.href);
  const connection = connect({
    address,
    page: location.href,
    open: createOpen(ask, isWithoutDatagrams),
    heard,
    changed: ({ kind }) => {
      if (kind !== 'here') presence.clear();
      if (kind === 'waiting' || kind === 'ended') peers.clear();
    },
  });
  const peers = startPeers({
    query: new URLSearchParams(location.search),
    ask,
    files: host.files,
    wanted: () => [...host.moving, ...(viewer.facts.entry?.rings ?? []).flatMap(filesOfRing)],
    isFirst: () => viewer.facts.arrived < 0,
    signal: connection.signal,
  });
  const sender = createSender((body, stops) => {
    // Beyond it no frame can say where the user is.
    const isSendable = [body.head, body.left, body.right].every((placed) => !placed || isWithin(placed.position));
    return isSendable && connection.pose(body, stops);
  });
  const aim = createAim((pose, place) => targetAt(viewer, nearShare, pose, place));
  let [seen, body]: [readonly Seen[], Body | null] = [[], null];
  let toldAt = -Infinity;
  /** Others who were there before the user. */
  let known = 0;
  viewer.setGuests(avatars);
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) sender.rest();
  });

  function heard(frame: FromServer, now: number): void {
    presence.hear(frame, now);
    peers.hear(frame);
    if (frame.kind === 'welcome') known = frame.others;
    if (frame.kind === 'welcome' || frame.kind === 'joined') sender.repeat();
    if (frame.kind === 'joined' && --known < 0) host.announce(`${frame.name} is here`);
  }

  function bodyOf(pose: Pose, now: number): Body {
    const hands = host.hands();
    if (hands) return inHeadset(pose, hands, ({ origin, direction }) => viewer.along(origin, direction) ?? NOTHING_HIT);
    return atScreen(pose, aim(pose, hold.place, now));
  }

  const room: Room = {
    connection,
    presence,
    avatars,
    peers,
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
      seen = presence.at(now);
      const { state } = connection;
      const own = state.kind === 'here' && body.pointer ? { number: state.user, body } : null;
      avatars.show(seen, own, pixelOf(viewer));
      if (now - toldAt < CARD_EVERY) return;
      toldAt = now;
      told(room);
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
