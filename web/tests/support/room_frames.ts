/** Frames as a server of rooms writes them, for tests. */
import { Writer } from '../../src/rooms/bytes';
import { type FromServer, SERVER } from '../../src/rooms/frames';
import { type Pose, writePose } from '../../src/rooms/pose';

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
  const body = new Writer();
  switch (frame.kind) {
    case 'welcome':
      body.u16(frame.user);
      body.u16(frame.others);
      writePrefixed(body, frame.ticket);
      break;
    case 'pose':
      body.u16(frame.user);
      writePose(body, frame.pose);
      break;
    case 'settled':
      body.u32(frame.sequence);
      break;
    case 'say':
      body.u16(frame.user);
      body.u8(frame.to === 'group' ? 0 : 1);
      body.put(frame.payload);
      break;
    case 'signal':
      body.u16(frame.user);
      body.put(frame.payload);
      break;
    case 'joined':
      body.u16(frame.user);
      body.u16(frame.group);
      writePrefixed(body, new TextEncoder().encode(frame.name));
      break;
    case 'left':
      body.u16(frame.user);
      break;
    case 'refused':
      body.u8(frame.reason);
      body.put(new TextEncoder().encode(frame.sentence));
  }
  return encodeBody(SERVER[frame.kind], body.toBytes());
}

/** Encodes a frame of a kind and a body. */
export function encodeBody(kind: number, body: Uint8Array): Uint8Array {
  const out = new Writer();
  out.u8(kind);
  out.u16(body.length);
  out.put(body);
  return out.toBytes();
}

function writePrefixed(out: Writer, bytes: Uint8Array): void {
  out.u8(bytes.length);
  out.put(bytes);
}
