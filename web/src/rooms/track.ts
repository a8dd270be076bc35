/**
 * Playback of another user's movement. The poses carry times of another clock, arrive with varying delays, or get lost.
 * The movement is drawn with a delay, which is the jitter of the poses plus the interval between two of them. If no
 * later pose has arrived by then, the movement is extrapolated for a moment and stops. Times are in seconds.
 */
import { clamp, subtract } from '../control/pose';
import { type Body, interpolateBodies, type Pose } from './pose';

/** Number of stored poses: more than half a second. */
const MAX_SAMPLES = 48;
/** Duration of the windows in which both clocks are compared. The last two windows count, because clocks drift. */
const WINDOW_SECONDS = 10;
/** Greatest duration of an extrapolation; greatest speed, metres per second: faster movements count as jumps. */
const [MAX_EXTRAPOLATION, MAX_SPEED] = [0.1, 20] as const;
/** Initial interval between poses; longer gaps than the second value do not count as intervals. */
const [INITIAL_INTERVAL, MAX_INTERVAL] = [1 / 72, 0.1] as const;
/** Greatest jitter that is compensated; time constant with which the measured jitter decays. */
const [MAX_JITTER, JITTER_DECAY] = [0.25, 3] as const;
/**
 * Greatest relative change of the playback speed, so small that nobody notices it; difference of delays above which
 * playback jumps.
 */
const [MAX_RATE_CHANGE, MAX_DRIFT] = [0.1, 0.5] as const;

interface Sample {
  readonly time: number;
  readonly sequence: number;
  readonly body: Body;
  readonly stops: boolean;
}

export type Track = ReturnType<typeof createTrack>;

export function createTrack() {
  let begin = 0n;
  let samples: Sample[] = [];
  let [interval, jitter, comparedAt] = [INITIAL_INTERVAL, 0, 0];
  /** Least difference between both clocks, in this window and in the one before. */
  let minDifference = { windowStart: 0, current: Infinity, previous: Infinity };
  /** Delay in seconds that is subtracted from local time; null until something is drawn. */
  let delay: number | null = null;
  let drawnAt = 0;

  /** Compares both clocks when a pose arrives. */
  function compare(difference: number, now: number): void {
    if (now - minDifference.windowStart > WINDOW_SECONDS)
      minDifference = { windowStart: now, current: difference, previous: minDifference.current };
    minDifference.current = Math.min(minDifference.current, difference);
    jitter = Math.max(jitter * Math.exp(-(now - comparedAt) / JITTER_DECAY), difference - offset());
    comparedAt = now;
  }

  function offset(): number {
    return Math.min(minDifference.current, minDifference.previous);
  }

  function add(sample: Sample): void {
    const index = lastIndexOf(samples, ({ sequence }) => sequence < sample.sequence) + 1;
    if (samples[index]?.sequence === sample.sequence) return;
    const before = samples[index - 1];
    const gap = sample.time - (before?.time ?? -Infinity);
    if (before && !before.stops && gap > 0 && gap < MAX_INTERVAL) interval += 0.1 * (gap - interval);
    samples = [...samples.slice(0, index), sample, ...samples.slice(index)].slice(-MAX_SAMPLES);
  }

  /** Returns the time at which the movement to a pose begins. */
  function beginOf(before: Sample, after: Sample): number {
    return before.stops ? Math.max(before.time, after.time - interval) : before.time;
  }

  function bodyAtClock(time: number): Body | null {
    const index = lastIndexOf(samples, (sample) => sample.time <= time);
    const [before, after] = [samples[index], samples[index + 1]];
    if (!before) return samples[0]?.body ?? null;
    if (!after) return extrapolate(samples[index - 1], before, time);
    const start = beginOf(before, after);
    return interpolateBodies(before.body, after.body, Math.max(time - start, 0) / (after.time - start));
  }

  function extrapolate(before: Sample | undefined, last: Sample, time: number): Body {
    if (!before || last.stops) return last.body;
    const duration = last.time - beginOf(before, last);
    const move = subtract(last.body.head.position, before.body.head.position);
    if (Math.hypot(...move) > MAX_SPEED * duration || !(duration > 0)) return last.body;
    return interpolateBodies(before.body, last.body, 1 + Math.min(time - last.time, MAX_EXTRAPOLATION) / duration);
  }

  return {
    /** Records a pose; duplicates are ignored. */
    hear(pose: Pose, now: number): void {
      const newest = samples.at(-1);
      let time = Number(pose.clock - begin) / 1e6;
      const isClockReset = newest && pose.sequence > newest.sequence && time <= newest.time;
      if (!newest || isClockReset) {
        [begin, time, samples] = [pose.clock, 0, []];
        [interval, jitter, delay] = [INITIAL_INTERVAL, 0, null];
        minDifference = { windowStart: -Infinity, current: Infinity, previous: Infinity };
      } else if (pose.sequence < newest.sequence && time >= newest.time) return;
      compare(now - time, now);
      add({ time, sequence: pose.sequence, body: pose, stops: pose.stops });
    },
    /** Returns the body at a time; null before the first pose. */
    bodyAt(now: number): Body | null {
      if (samples.length === 0) return null;
      const targetDelay = offset() + interval + Math.min(jitter, MAX_JITTER);
      const change = targetDelay - (delay ?? targetDelay);
      const maxChange = MAX_RATE_CHANGE * Math.max(now - drawnAt, 0);
      const isDrift = delay !== null && Math.abs(change) < MAX_DRIFT;
      delay = isDrift ? (delay ?? 0) + clamp(change, -maxChange, maxChange) : targetDelay;
      drawnAt = now;
      return bodyAtClock(now - delay);
    },
    /** Delay of the drawn movement beyond the least latency of poses, seconds. */
    get addedDelay(): number {
      return delay === null ? 0 : delay - offset();
    },
  };
}

/** Returns the index of the last sample that satisfies a condition, or −1. */
function lastIndexOf(samples: readonly Sample[], condition: (sample: Sample) => boolean): number {
  let index = samples.length - 1;
  while (index >= 0 && !condition(samples[index] as Sample)) index -= 1;
  return index;
}
