/** Position and direction of the user's head in the world: metres, y up, radians. */
export interface Pose {
  readonly position: readonly [number, number, number];
  /** Turn about the vertical axis; 0 looks along −z, positive to the left. */
  readonly yaw: number;
  /** Positive looks up. */
  readonly pitch: number;
}
