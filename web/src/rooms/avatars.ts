/** Avatars of all who are seen, and the user's own pointer, as guests of the picture. */
import type { Point } from '../bundle/manifest';
import type { Shared } from '../show/materials';
import type { Guests } from '../show/picture';
import { shownName } from './address';
import { type Avatar, createAvatar, type Drawn } from './avatar';
import type { Body } from './pose';
import type { Seen } from './presence';
import { createShapes } from './shapes';

export interface Avatars extends Guests {
  readonly meshes: readonly Drawn[];
  /** Those who are drawn from now on; `pixel` is the tangent of the angle that a pixel covers. */
  show(seen: readonly Seen[], own: Own | null, pixel: number): void;
}

/** The user itself, of whom its own picture shows the pointer alone. */
export interface Own {
  readonly number: number;
  readonly body: Body;
}

interface Kept {
  readonly name: string;
  readonly avatar: Avatar;
}

export function createAvatars(shared: Shared): Avatars {
  const shapes = createShapes();
  const common = { ...shared, pixel: { value: 0 } };
  const kept = new Map<number, Kept>();

  function of(number: number, name: string): Avatar {
    const found = kept.get(number);
    if (found?.name === name) return found.avatar;
    found?.avatar.dispose();
    const avatar = createAvatar(number, name, shapes, common);
    kept.set(number, { name, avatar });
    return avatar;
  }

  function forget(others: ReadonlySet<number>): void {
    for (const [number, { avatar }] of kept) {
      if (others.has(number)) continue;
      avatar.dispose();
      kept.delete(number);
    }
  }

  return {
    get meshes() {
      return [...kept.values()].flatMap(({ avatar }) => avatar.meshes);
    },
    show(seen, own, pixel) {
      common.pixel.value = pixel;
      forget(new Set([...seen.map(({ number }) => number), ...(own ? [own.number] : [])]));
      for (const { number, name, body } of seen) of(number, shownName(name, number)).show(body, true);
      if (own) of(own.number, '').show(own.body, false);
    },
    place(center: Point) {
      for (const { avatar } of kept.values()) avatar.place(center);
    },
  };
}
