/** Users in the room, and their current bodies. */
import type { FromServer } from './frames';
import type { Body } from './pose';
import { createTrack, type Track } from './track';

export interface Guest {
  readonly number: number;
  readonly name: string;
  readonly group: number;
  /** Whether its pointer is hidden. */
  readonly isMuted: boolean;
}

/** Guest with its current body. */
export interface Seen extends Guest {
  readonly body: Body;
}

export interface Presence {
  /** All other users of the room, sorted by number; a new list after each change. */
  readonly guests: readonly Guest[];
  /** Handles a frame of the server. */
  hear(frame: FromServer, now: number): void;
  /** Forgets all users, because the connection is closed. */
  clear(): void;
  mute(number: number, isMuted: boolean): void;
  /** Returns the guests with known poses, with their bodies at a time. */
  at(now: number): Seen[];
}

export function createPresence(): Presence {
  const tracks = new Map<number, Track>();
  // A returning user keeps its number and stays muted.
  const muted = new Set<number>();
  let guests: readonly Guest[] = [];

  function without(number: number): readonly Guest[] {
    tracks.delete(number);
    return guests.filter((guest) => guest.number !== number);
  }

  function clear(): void {
    tracks.clear();
    guests = [];
  }

  return {
    get guests() {
      return guests;
    },
    clear,
    hear(frame, now) {
      if (frame.kind === 'welcome') clear();
      else if (frame.kind === 'left') guests = without(frame.user);
      else if (frame.kind === 'joined') {
        const { user: number, group, name } = frame;
        const others = without(number);
        tracks.set(number, createTrack());
        const guest = { number, group, name, isMuted: muted.has(number) };
        guests = [...others, guest].sort((a, b) => a.number - b.number);
      } else if (frame.kind === 'pose') {
        tracks.get(frame.user)?.hear(frame.pose, now);
      }
    },
    mute(number, isMuted) {
      if (isMuted) muted.add(number);
      else muted.delete(number);
      guests = guests.map((guest) => (guest.number === number ? { ...guest, isMuted } : guest));
    },
    at(now) {
      return guests.flatMap((guest) => {
        const body = tracks.get(guest.number)?.at(now);
        if (!body) return [];
        return [{ ...guest, body: guest.isMuted ? { ...body, pointer: null } : body }];
      });
    },
  };
}
