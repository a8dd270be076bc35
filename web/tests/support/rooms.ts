/** Frames as a server of rooms writes them, for tests. */
import { encode } from '../../src/rooms/bytes';
import { type FromServer, SERVER_FRAME } from '../../src/rooms/frames';
import type { Pose } from '../../src/rooms/pose';

/** A pose at the origin that looks along −z. */
export const REST: Pose = {
  sequence: 1,
  clock: 0n,
  isAcknowledged: false,
  stops: false,
  head: { position: [0, 0, 0], rotation: [0, 0, 0, 1] },
  left: null,
  right: null,
  pointer: null,
};

export function encodeFrame(frame: FromServer): Uint8Array {
  return encode(SERVER_FRAME, frame);
}

/** Encodes a frame with a kind and a body. */
export function encodeBody(kind: number, body: Uint8Array): Uint8Array {
  return Uint8Array.from([kind, body.length & 0xff, body.length >> 8, ...body]);
}
