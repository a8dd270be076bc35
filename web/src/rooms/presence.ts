/** Other users in the room, and their current bodies. */
import type { FromServer } from './frames';
import type { Body } from './pose';
import { createTrack, type Track } from './track';

/** Another user in the room. */
export interface Guest {
  readonly number: number;
  readonly name: string;
  readonly group: number;
  /** Whether the pointer of the user is hidden. */
  readonly isMuted: boolean;
}

/** User with the current body. */
export interface VisibleGuest extends Guest {
  readonly body: Body;
}

export function createPresence() {
  const tracks = new Map<number, Track>();
  // A returning user keeps its number and stays muted.
  const muted = new Set<number>();
  let guests: readonly Guest[] = [];

  function removeGuest(number: number): void {
    tracks.delete(number);
    guests = guests.filter((guest) => guest.number !== number);
  }

  /** Forgets all users, because the connection is closed. */
  function clear(): void {
    tracks.clear();
    guests = [];
  }

  return {
    /** All other users of the room, sorted by number; a new list after each change. */
    get guests(): readonly Guest[] {
      return guests;
    },
    clear,
    hear(frame: FromServer, now: number): void {
      if (frame.kind === 'welcome') clear();
      else if (frame.kind === 'left') removeGuest(frame.user);
      else if (frame.kind === 'joined') {
        const { user: number, group, name } = frame;
        removeGuest(number);
        tracks.set(number, createTrack());
        const guest = { number, group, name, isMuted: muted.has(number) };
        guests = [...guests, guest].sort((a, b) => a.number - b.number);
      } else if (frame.kind === 'pose') tracks.get(frame.user)?.hear(frame.pose, now);
    },
    mute(number: number, isMuted: boolean): void {
      if (isMuted) muted.add(number);
      else muted.delete(number);
      guests = guests.map((guest) => (guest.number === number ? { ...guest, isMuted } : guest));
    },
    /** Returns the users whose pose is known, with their bodies at a time. */
    visibleAt(now: number): VisibleGuest[] {
      return guests.flatMap((guest) => {
        const body = tracks.get(guest.number)?.bodyAt(now);
        if (!body) return [];
        return [{ ...guest, body: guest.isMuted ? { ...body, pointer: null } : body }];
      });
    },
  };
}
