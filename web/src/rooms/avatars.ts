/** Avatars of all visible users, and the user's own pointer, as guests of the picture. */
import { type Camera, Scene, Vector4, type WebGLRenderer } from 'three';
import type { Point } from '../bundle/manifest';
import type { Shared } from '../show/materials';
import type { Guests } from '../show/painter';
import { shownName } from './address';
import { type Avatar, createAvatar } from './avatar';
import { createRay, createShapes, type Drawn, paint } from './meshes';
import type { Body } from './pose';
import type { Seen } from './presence';

/** Greatest number of unused avatars that are kept for new users. */
const MAX_SPARE_AVATARS = 16;

export interface Avatars extends Guests {
  readonly meshes: readonly Drawn[];
  /** Sets the users to draw; `pixel` is the tangent of the angle of a pixel. */
  show(seen: readonly Seen[], own: Own | null, pixel: number): void;
  /** Compiles the shaders that the first user needs. */
  prepare(renderer: WebGLRenderer, camera: Camera): void;
}

/** The user itself, whose own picture shows only the pointer. */
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
  const color = new Vector4();
  const ray = createRay(shapes, common, color);
  let pointing: Own | null = null;
  // three.js deletes a program with its last material, and would recompile it for the next user.
  const spare: Avatar[] = [createAvatar(shapes, common)];

  function avatarOf(number: number, name: string): Avatar {
    const found = kept.get(number);
    if (found?.name === name) return found.avatar;
    const avatar = found?.avatar ?? spare.pop() ?? createAvatar(shapes, common);
    avatar.be(number, name);
    kept.set(number, { name, avatar });
    return avatar;
  }

  function forget(others: ReadonlySet<number>): void {
    for (const [number, { avatar }] of kept) {
      if (others.has(number)) continue;
      kept.delete(number);
      if (spare.length < MAX_SPARE_AVATARS) spare.push(avatar);
      else avatar.dispose();
    }
  }

  return {
    get meshes() {
      const others = [...kept.values()].flatMap(({ avatar }) => avatar.meshes);
      return pointing ? [...others, ray.mesh] : others;
    },
    show(seen, own, pixel) {
      common.pixel.value = pixel;
      forget(new Set(seen.map(({ number }) => number)));
      for (const { number, name, body } of seen) avatarOf(number, shownName(name, number)).show(body);
      pointing = own?.body.pointer ? own : null;
      if (pointing) paint(color, pointing.number);
    },
    prepare(renderer, camera) {
      const meshes = spare.flatMap((avatar) => avatar.meshes);
      renderer.compile(new Scene().add(...meshes, ray.mesh), camera);
    },
    place(center: Point) {
      for (const { avatar } of kept.values()) avatar.place(center);
      if (pointing) ray.place(pointing.body, center);
    },
  };
}
