/** Signals that are sent no faster than a room takes them from a user. */
import type { Clock } from '../rooms/clock';
import { createBucket } from './bucket';

/** Bytes a second and at once, below what docs/rooms.md allows; and bytes that count for less. */
const [RATE, BURST, LEAST] = [24_576, 12_288, 64] as const;
/** Signals that wait at most. */
const MOST_WAITING = 64;

export interface Outbox {
  send(user: number, payload: Uint8Array): void;
  /** Forget what waits. */
  clear(): void;
}

export function createOutbox(send: (user: number, payload: Uint8Array) => void, clock: Clock): Outbox {
  const bucket = createBucket(RATE, BURST, clock.now);
  let waiting: (readonly [user: number, payload: Uint8Array])[] = [];
  let isWaiting = false;

  function flush(): void {
    for (let next = waiting[0]; next; next = waiting[0]) {
      const [user, payload] = next;
      const size = Math.min(Math.max(payload.length, LEAST), BURST);
      if (!bucket.take(size)) {
        isWaiting = true;
        clock.later(bucket.secondsTo(size) + 0.01, () => {
          isWaiting = false;
          flush();
        });
        return;
      }
      waiting = waiting.slice(1);
      send(user, payload);
    }
  }

  return {
    send(user, payload) {
      if (waiting.length >= MOST_WAITING) return;
      waiting.push([user, payload]);
      if (!isWaiting) flush();
    },
    clear() {
      waiting = [];
    },
  };
}
