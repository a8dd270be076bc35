/** Something that users of a room do together. */
import type { Pose } from '../control/pose';
import type { Vector } from '../control/vector';
import type { Guests } from '../show/picture';
import type { FromServer } from './frames';
import type { Place } from './hold';
import type { Body } from './pose';

/** It draws what guests are drawn as. */
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
