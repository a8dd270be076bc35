/** Room in the page: bodies and pointers of other users. A separate script, which only users of rooms load. */
import { filesOfRing } from './bundle/contents';
import type { Files } from './bundle/source';
import type { Pose } from './control/pose';
import { startPeers } from './peers/start';
import { type Address, inviteOf, readAddress, relayOf, displayName } from './rooms/address';
import { createAvatars } from './rooms/avatars';
import { type CardCommands, createArrivals, createRoomCard } from './rooms/card';
import { CLOCK } from './rooms/clock';
import { connect } from './rooms/connection';
import type { FromServer } from './rooms/frames';
import { createHold } from './rooms/hold';
import { type Activity, createPointing } from './rooms/pointing';
import { type Body, isInRange } from './rooms/pose';
import { createPresence, type VisibleGuest } from './rooms/presence';
import { createSender } from './rooms/sending';
import { type Ask, askDescription } from './rooms/server';
import { createTicketStore, followPage } from './rooms/ticket';
import { createOpen } from './rooms/transports';
import type { Viewer } from './show/viewer';
import { make } from './ui/dom';
import type { Row } from './ui/help';
import type { HandRay } from './xr/hands';

/** Seconds between two updates of the card. */
const CARD_INTERVAL = 0.25;

const HELP: readonly Row[] = [
  [['E'], 'point at the cursor, while held'],
  [['Middle button'], 'the same'],
  [['Point'], 'point at the middle of the picture'],
  [['Grip'], 'headset: point along the controller'],
  [['Index finger'], 'headset: point by it alone, the others bent'],
];

/** Interface that the page offers to a room. */
export interface Host {
  readonly viewer: Viewer;
  readonly canvas: HTMLCanvasElement;
  readonly root: HTMLElement;
  readonly files: Files;
  /** Files of moving objects, which every region needs. */
  readonly movingFiles: readonly string[];
  /** r1 as a share of r2. */
  readonly nearShare: number;
  /** Hands of the headset; null outside a session. */
  hands(): readonly HandRay[] | null;
  /** Moves the user to another place when it can be shown. */
  go(pose: Pose): void;
  announce(text: string): void;
  /** Adds a section to the help. */
  addHelp(title: string, rows: readonly Row[]): void;
}

export type Room = ReturnType<typeof join>;

/** Joins the room that the page's address names; null if the address is invalid. */
export function enter(host: Host): Room | null {
  document.head.append(make('link', { rel: 'stylesheet', href: new URL('rooms.css', import.meta.url).href }));
  const address = readAddress(new URLSearchParams(location.search));
  const commands: CardCommands = {
    mute: (number, isMuted) => room?.presence.mute(number, isMuted),
    retry: () => room?.connection.retry(),
    leave: () => room?.connection.leave(),
    link: () => inviteOf(location.href),
    announce: host.announce,
    exchange: (isOn) => room?.peers.switch?.set(isOn),
  };
  const card = createRoomCard(host.root, commands);
  if (typeof address === 'string') {
    card.refuse(address);
    return null;
  }
  host.addHelp('Room', HELP);
  const room = join(host, address, card);
  return room;
}

function join(host: Host, address: Address, card: ReturnType<typeof createRoomCard>) {
  const { viewer, nearShare } = host;
  const hold = createHold(host.canvas, card.button);
  const presence = createPresence();
  const avatars = createAvatars(viewer.shared);
  const arrivals = createArrivals(host.announce);
  const tickets = createTicketStore(relayOf(location.href, { ...address, token: null }));
  const isWithoutDatagrams = new URLSearchParams(location.search).get('datagrams') === 'off';
  const ask: Ask = () => askDescription(location.href);
  const connection = connect({
    address,
    page: location.href,
    open: createOpen(ask, isWithoutDatagrams),
    ticket: tickets.take(),
    onFrame: hear,
    onChange: ({ kind }) => {
      if (kind !== 'here') presence.clear();
      if (kind === 'waiting' || kind === 'ended') peers.clear();
    },
  });
  const peers = startPeers({
    query: new URLSearchParams(location.search),
    ask,
    files: host.files,
    shownNames: () => [...host.movingFiles, ...(viewer.facts.entry?.rings ?? []).flatMap(filesOfRing)],
    isFirstPictureMissing: () => viewer.facts.arrived < 0,
    signal: connection.signal,
  });
  const sender = createSender((body, stops) => {
    // Frames cannot encode positions outside the range.
    const isSendable = [body.head, body.left, body.right].every((part) => !part || isInRange(part.position));
    return isSendable && connection.pose(body, stops);
  });
  const bodyOf = createPointing(viewer, nearShare, hold, host.hands, () => activity);
  let [visible, body]: [readonly VisibleGuest[], Body | null] = [[], null];
  let updatedAt = -Infinity;
  let activity: Activity | null = null;
  avatars.prepare(viewer.renderer, viewer.camera);
  viewer.setGuests(avatars);
  followPage(connection, tickets);
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) sender.rest();
  });

  function hear(frame: FromServer, now: number): void {
    presence.hear(frame, now);
    peers.hear(frame);
    if (frame.kind === 'welcome' || frame.kind === 'joined') sender.repeat();
    if (frame.kind === 'welcome') arrivals.begin(frame.others);
    else if (frame.kind === 'joined') arrivals.add(frame.user, displayName(frame.name, frame.user));
    else if (frame.kind === 'left') arrivals.remove(frame.user);
    activity?.hear(frame, now);
  }

  return {
    address,
    connection,
    presence,
    avatars,
    /** Exchange of files with other users. */
    peers,
    /** Other users as last drawn. */
    get seen(): readonly VisibleGuest[] {
      return visible;
    },
    get body(): Body | null {
      return body;
    },
    /** Updates the room before each frame with the user's pose. */
    frame(pose: Pose): void {
      const now = CLOCK.now();
      body = bodyOf(pose, now);
      sender.update(body, now);
      activity?.frame(pose, body, now);
      visible = presence.visibleAt(now);
      const { state } = connection;
      const own = state.kind === 'here' && body.pointer ? { number: state.user, body } : null;
      avatars.show(visible, own, pixelOf(viewer));
      arrivals.announceDue(now);
      if (now - updatedAt < CARD_INTERVAL) return;
      updatedAt = now;
      const { others, server } = peers.counts;
      card.update(state, {
        name: address.name,
        group: address.group,
        guests: presence.guests,
        roundTrip: connection.roundTrips.median,
        files: peers.refusal === null ? { others: others.bytes, server: server.bytes } : null,
        wantsExchange: peers.switch?.isOn ?? null,
      });
    },
    /** Shared task of the users; null for none. */
    get activity(): Activity | null {
      return activity;
    },
    /** Starts a shared task. */
    begin(next: Activity): void {
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
}

/** Tangent of the angle of a pixel in the middle of the picture, in a headset of an eye's picture. */
function pixelOf({ camera, renderer }: Viewer): number {
  const [eye] = renderer.xr.isPresenting ? renderer.xr.getCamera().cameras : [];
  const { projectionMatrix } = eye ?? camera;
  const height = eye?.viewport?.w ?? renderer.domElement.height;
  return 2 / (projectionMatrix.elements[5] * Math.max(height, 1));
}
