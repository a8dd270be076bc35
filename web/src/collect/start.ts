/** Sphere collection in the page, loaded as a separate script only by its users. */
import type { Point } from '../bundle/manifest';
import { clamp, type Pose, unit, type Vector } from '../control/pose';
import type { Host, Room } from '../room';
import { FrameError } from '../rooms/bytes';
import { CLOCK } from '../rooms/clock';
import type { FromServer } from '../rooms/frames';
import type { ScreenPoint } from '../rooms/hold';
import type { Activity } from '../rooms/pointing';
import { type Body, rotate } from '../rooms/pose';
import { make } from '../ui/dom';
import { createBall, pointAtDistance } from './ball';
import { audienceOf, type Box, type Message, read, write } from './messages';
import { type CardState, createPanel } from './panel';
import { readRules, type RuleParameters, rulesAt } from './rules';
import type { Ray } from './spheres';
import { Task } from './task';

/** Interval of the card's updates, seconds. */
const CARD_INTERVAL = 0.1;
/** Greatest number of other groups whose scores the card shows. */
const MAX_GROUPS = 8;
/** Least seconds between two moves to a seat; greatest distance of a seat from the rectangle, metres. */
const [SEAT_INTERVAL, SEAT_MARGIN] = [3, 2] as const;

/** Starts the sphere collection for a room's users, with rules from the page's address. */
export function begin(room: Room, host: Host): void {
  document.head.append(make('link', { rel: 'stylesheet', href: new URL('collect.css', import.meta.url).href }));
  const parameters = readRules(new URLSearchParams(location.search));
  if (typeof parameters === 'string') host.announce(parameters);
  else collect(room, host, parameters);
}

function collect(room: Room, host: Host, parameters: RuleParameters): void {
  const { viewer } = host;
  const ball = createBall(viewer.shared);
  const rays = new Map<number, Ray>();
  const groups = new Map<number, number>();
  const panel = createPanel(host.root, start);
  let task: Task | null = null;
  let pose: Pose | null = null;
  let seatedStage = '';
  let [updatedAt, seatedAt] = [-Infinity, -Infinity];
  /** Number of frames drawn in the trial, and times of the first and the last one. */
  let [frameCount, firstFrame, lastFrame] = [0, 0, 0];

  function start(): void {
    if (!task || !pose || !canStart(task)) return;
    const middle = viewer.facts.entry?.center ?? pose.position;
    const now = CLOCK.now();
    send(task.start(rulesAt(parameters, middle, pose.yaw), now));
    moveToSeat(task, now);
  }

  /** Whether the user may start a run: only the conductor, with enough users, while no trial runs or is to follow. */
  function canStart(activeTask: Task): boolean {
    const hasEnoughUsers = activeTask.present.size >= Math.min(parameters.users, 2);
    return activeTask.user === activeTask.conductor && hasEnoughUsers && (activeTask.trial === null || activeTask.isOver);
  }

  function send(messages: readonly Message[]): void {
    for (const message of messages) room.connection.say(write(message), audienceOf(message));
  }

  function sendMessages(now: number): void {
    if (!task || room.connection.state.kind !== 'here') return;
    send(task.conduct(now, rays));
    moveToSeat(task, now);
  }

  /** Moves the user to the assigned seat when a trial has begun. */
  function moveToSeat(activeTask: Task, now: number): void {
    const { trial, seat } = activeTask;
    const stage = trial ? `${trial.run} ${trial.trial}` : '';
    if (stage === seatedStage || now - seatedAt < SEAT_INTERVAL) return;
    seatedStage = stage;
    [frameCount, firstFrame, lastFrame] = [0, now, now];
    if (!seat || !trial || !isNearBox(trial.area, seat)) return;
    seatedAt = now;
    const [[minX, , minZ], [maxX, , maxZ]] = trial.box;
    const yaw = Math.atan2(seat[0] - (minX + maxX) / 2, seat[2] - (minZ + maxZ) / 2);
    host.go({ position: seat, yaw, pitch: 0 });
    host.announce(`Trial ${trial.trial} of ${trial.trials}: all aim at the sphere at the same time`);
  }

  function hearPayload(user: number, payload: Uint8Array, now: number): void {
    const group = groups.get(user);
    if (!task || group === undefined) return;
    try {
      const message = read(payload);
      if (message) task.hear(message, now, user, group);
    } catch (error) {
      // Malformed messages are ignored.
      if (!(error instanceof FrameError)) throw error;
    }
    moveToSeat(task, now);
  }

  function enter(user: number): void {
    groups.clear();
    rays.clear();
    // A user who returns with the same number continues from the old state.
    if (task?.user === user) task.resetUsers();
    else task = new Task(user, room.address.group);
  }

  function show(activeTask: Task | null, now: number): void {
    const trial = room.connection.state.kind === 'here' ? activeTask?.trial : null;
    if (!activeTask || !trial) return ball.show(null, 0, 0, 0);
    const heldShare = activeTask.heldSince === null ? 0 : (now - activeTask.heldSince) / Math.max(trial.hold, 1e-3);
    ball.show(activeTask.place(now), trial.radius, activeTask.aims.length / activeTask.needed, Math.min(heldShare, 1));
  }

  function cardState(now: number): CardState {
    const frameRate = frameCount > 0 && lastFrame > firstFrame ? frameCount / (lastFrame - firstFrame) : null;
    const common = { now, frameRate, roundTrip: room.connection.roundTrips.median };
    if (!task || room.connection.state.kind !== 'here')
      return { ...common, instruction: 'Not in the room', canStart: false, task: null, otherScores: '' };
    const { group } = task;
    const scores = [...task.scores]
      .filter(([other]) => other !== group)
      .sort(([a], [b]) => a - b)
      .slice(0, MAX_GROUPS)
      .map(([other, { spheres, misses }]) => `Group ${other}: ${spheres} spheres, ${misses} misses`);
    const isStartable = canStart(task);
    const instruction = instructionOf(task, isStartable);
    return { ...common, instruction, canStart: isStartable, task, otherScores: scores.join(' · ') };
  }

  const activity = {
    /** State of the task; null before the user is in the room. */
    get task(): Task | null {
      return task;
    },
    get meshes(): Activity['meshes'] {
      return ball.meshes;
    },
    get isPointing(): boolean {
      return task?.trial?.over === false;
    },
    place: (center: Point): void => ball.place(center),
    hear(frame: FromServer, now: number): void {
      if (frame.kind === 'welcome') enter(frame.user);
      else if (frame.kind === 'joined') {
        groups.set(frame.user, frame.group);
        if (frame.group === room.address.group) task?.addUser(frame.user);
      } else if (frame.kind === 'left') {
        groups.delete(frame.user);
        rays.delete(frame.user);
        task?.removeUser(frame.user);
        task?.forgetScores((group) => group === room.address.group || [...groups.values()].includes(group));
      } else if (frame.kind === 'pose') {
        storeRay(rays, frame.user, frame.pose);
        // A hidden page gets poses, but no animation frames.
        sendMessages(now);
      } else if (frame.kind === 'say') hearPayload(frame.user, frame.payload, now);
    },
    frame(userPose: Pose, body: Body, now: number): void {
      pose = userPose;
      if (task) storeRay(rays, task.user, body);
      sendMessages(now);
      if (task?.trial?.over === false) [frameCount, lastFrame] = [frameCount + 1, now];
      show(task, now);
      if (now - updatedAt < CARD_INTERVAL) return;
      updatedAt = now;
      panel.update(cardState(now));
    },
    targetAt(from: Pose, place: ScreenPoint): Vector | null {
      const sphere = task?.place(CLOCK.now());
      return sphere ? pointAtDistance(viewer, host.nearShare, from, place, sphere) : null;
    },
  };
  const { state } = room.connection;
  if (state.kind === 'here') {
    enter(state.user);
    for (const { number, group } of room.presence.guests)
      activity.hear({ kind: 'joined', user: number, group, name: '' }, CLOCK.now());
  }
  room.begin(activity);
}

/** Stores the ray of a user's pointer; removes it if the user does not point. */
function storeRay(rays: Map<number, Ray>, user: number, body: Body): void {
  const origin = body.pointer && body[body.pointer.begin];
  // Quaternions in frames may deviate from length 1 by a tenth.
  if (origin) rays.set(user, { begin: origin.position, direction: unit(rotate(origin.rotation, [0, 0, -1])) });
  else rays.delete(user);
}

/** Whether a place is at most `SEAT_MARGIN` metres outside a box along each axis. */
function isNearBox([least, most]: Box, place: Vector): boolean {
  return place.every((value, axis) => Math.abs(value - clamp(value, least[axis] ?? value, most[axis] ?? value)) <= SEAT_MARGIN);
}

function instructionOf(task: Task, canStart: boolean): string {
  if (task.trial && !task.trial.over) return task.seat ? '' : 'You get a seat in the next trial';
  if (task.trial && !task.isOver) return 'The next trial begins in a moment';
  if (canStart) return `Users of your group: ${task.present.size}. Look to where the spheres should appear, and start.`;
  return task.user === task.conductor ? 'Waiting for others of your group' : `#${task.conductor} starts the trials`;
}
