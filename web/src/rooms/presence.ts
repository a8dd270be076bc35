/** Who is in the room, and where they are shown. */
import type { FromServer } from './frames';
import type { Body } from './pose';
import { createTrack, type Track } from './track';

export interface Guest {
  readonly number: number;
  readonly name: string;
  readonly group: number;
  /** Its pointer is not shown. */
  readonly isMuted: boolean;
}

/** A guest with what is drawn of it. */
export interface Seen extends Guest {
  readonly body: Body;
}

export interface Presence {
  /** All others of the room, by their numbers; another list after each change. */
  readonly guests: readonly Guest[];
  /** A frame of the server has come. */
  hear(frame: FromServer, now: number): void;
  /** The connection is gone, and nobody is known any more. */
  clear(): void;
  mute(number: number, isMuted: boolean): void;
  /** Those who have told where they are, as they are drawn now. */
  at(now: number): Seen[];
}

export function createPresence(): Presence {
  const tracks = new Map<number, Track>();
  // Who comes back keeps its number, and stays muted.
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
