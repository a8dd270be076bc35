/** Queue of signals that respects the rate limit of a room. */
import type { Clock } from '../rooms/clock';
import { createBucket } from './bucket';

/** Bytes per second and burst, below the limits of docs/rooms.md; least bytes that a signal counts for. */
const [RATE, BURST, MIN] = [24_576, 12_288, 64] as const;
/** Greatest number of queued signals. */
const MAX_WAITING = 64;

export interface Outbox {
  send(user: number, payload: Uint8Array): void;
  /** Discards queued signals. */
  clear(): void;
}

export function createOutbox(send: (user: number, payload: Uint8Array) => void, clock: Clock): Outbox {
  const bucket = createBucket(RATE, BURST, clock.now);
  let waiting: (readonly [user: number, payload: Uint8Array])[] = [];
  let isWaiting = false;

  function flush(): void {
    for (let next = waiting[0]; next; next = waiting[0]) {
      const [user, payload] = next;
      const size = Math.min(Math.max(payload.length, MIN), BURST);
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
      if (waiting.length >= MAX_WAITING) return;
      waiting.push([user, payload]);
      if (!isWaiting) flush();
    },
    clear() {
      waiting = [];
    },
  };
}
