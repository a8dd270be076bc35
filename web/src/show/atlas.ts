/** The open regions: what is loaded of each, and the picture that it would show. */
import { abortable } from '../base/errors';
import { type ArrivingRegion, bytesOf, filesOfRegion } from '../bundle/contents';
import type { Manifest, RingEntry } from '../bundle/manifest';
import type { WorkerMemory } from '../decode/messages';
import type { Regions } from './journey';
import { type Loading, loadRegion } from './loader';
import { markTimeline } from './meter';
import { createRegion, type Region } from './region';
import { createStage, type Manner, type MorphState, type Shown, type Stage } from './stage';
import type { World } from './world';

/** Region that is open: its manifest is loaded. */
export type OpenRegion = ReturnType<typeof createOpenRegion>;

function createOpenRegion(number: number, region: Region, stage: Stage, stop: AbortController, manifest: Manifest) {
  const neededFiles = (): ReadonlySet<string> => filesOfRegion(manifest, region.entry);
  return {
    number,
    region,
    stage,
    stop,
    /** Names of its files, as far as the manifest lists them so far. */
    neededFiles,
    /** Last loaded ring; −1 before ring 0. */
    arrived: -1,
    /** Picture of the current frame, or of the last frame that showed the region. */
    shown: null as Shown | null,
    /** Received bytes of its files. */
    received: 0,
    /** Bytes of all files known so far. */
    get expected(): number {
      return bytesOf(manifest, neededFiles());
    },
    state: 'loading' as 'loading' | 'complete' | 'failed',
    /** Whether it waits for the server's next ring, so that other regions may load meanwhile. */
    isIdle: false,
  };
}

/** Region whose manifest is being loaded. */
interface Pending {
  readonly stop: AbortController;
  /** State in which its picture begins; null if the region is not shown yet. */
  from: MorphState | null;
  hasFailed: boolean;
}

/** Facts of all regions. */
export interface AtlasFacts {
  /** Numbers of the regions that are open or whose manifest is loading. */
  readonly regions: readonly number[];
  readonly isLoading: boolean;
  /** Buffers and maps that the workers still had after the last region was closed. */
  readonly kept: readonly WorkerMemory[];
}

export type Atlas = ReturnType<typeof createAtlas>;

/** Creates an atlas without regions; calls `onFailure` when a region cannot be loaded. */
export function createAtlas(
  world: World,
  loading: Loading,
  manner: Manner,
  onFailure: (region: number, reason: Error) => void,
) {
  const { renderer, store } = loading;
  const { nearShare } = world;
  const openRegions = new Map<number, OpenRegion>();
  const pendingRegions = new Map<number, Pending>();
  let order: readonly number[] = [];
  /** Loadings that wait for their turn. */
  let waiting: { region: number; done: () => void }[] = [];
  let workerMemory: readonly WorkerMemory[] = [];

  /** Gives the turn to the first region that can load a ring. */
  function resumeNext(): void {
    const next = order.find((region) => isLoading(openRegions.get(region)));
    const resumed = waiting.filter(({ region }) => region === next);
    waiting = waiting.filter(({ region }) => region !== next);
    for (const { done } of resumed) done();
  }

  /** Waits until the server has a ring and it is the region's turn. */
  async function waitForRing(open: OpenRegion, arriving: ArrivingRegion, ring: number): Promise<RingEntry> {
    const entry = arriving.ring(ring);
    if (entry instanceof Promise) {
      open.isIdle = true;
      resumeNext();
      await entry;
      open.isIdle = false;
    }
    await abortable<void>(open.stop.signal, (done) => {
      waiting.push({ region: open.number, done });
      resumeNext();
    });
    return entry;
  }

  /** Loads the manifest of a region, then its rings. If `from` is not null, the region is shown, similar to `from`. */
  function request(number: number, from: MorphState | null = null): void {
    const pending: Pending = { stop: new AbortController(), from, hasFailed: false };
    const { signal } = pending.stop;
    pendingRegions.set(number, pending);
    world.open(number, signal).then(
      (arriving) => {
        if (signal.aborted) return;
        pendingRegions.delete(number);
        const { stage } = begin(number, arriving, pending.stop);
        if (pending.from) stage.enter(pending.from);
      },
      (reason: unknown) => {
        if (signal.aborted) return;
        pending.hasFailed = true;
        onFailure(number, asError(reason));
      },
    );
  }

  function begin(number: number, arriving: ArrivingRegion, stop: AbortController): OpenRegion {
    const { entry, manifest } = arriving;
    const radii = entry.rings.slice(1).map((ring) => ring.radius);
    const stage = createStage({ ...manifest.growth, radii, nearShare }, manner);
    const region = createRegion(renderer, entry, manifest.map.face_size, store, loading.shared);
    const open = createOpenRegion(number, region, stage, stop, manifest);
    openRegions.set(number, open);
    const finish = (state: OpenRegion['state']): void => {
      open.state = state;
      resumeNext();
    };
    loadRegion(loading, {
      manifest,
      region,
      number,
      onRing(ring) {
        open.arrived = ring;
        markTimeline('arrived', number, ring);
        stage.arrive(ring);
      },
      onBytes: (bytes) => {
        open.received += bytes;
      },
      waitForRing: (ring) => waitForRing(open, arriving, ring),
      waitForCube: (ring) => stage.waitForCube(ring),
      signal: stop.signal,
    }).then(
      () => finish('complete'),
      (reason: unknown) => {
        if (stop.signal.aborted) return;
        finish('failed');
        onFailure(number, asError(reason));
      },
    );
    return open;
  }

  function end(open: OpenRegion): void {
    openRegions.delete(open.number);
    open.stop.abort();
    open.region.dispose();
    waiting = waiting.filter(({ region }) => region !== open.number);
    const files = new Set([...openRegions.values()].flatMap((other) => [...other.neededFiles()]));
    const request = { kind: 'forget', buffers: store.freeExcept(files), region: open.number } as const;
    Promise.all([loading.geometry(request), loading.maps(request)])
      .then((answers) => (workerMemory = answers))
      // The error of a stopped worker is reported to its pending requests.
      .catch(() => undefined);
  }

  const regions: Regions = {
    open(region) {
      if (!openRegions.has(region) && !pendingRegions.has(region)) request(region);
    },
    close(region) {
      pendingRegions.get(region)?.stop.abort();
      pendingRegions.delete(region);
      const open = openRegions.get(region);
      if (open) end(open);
    },
    prefer(next) {
      order = next;
      resumeNext();
    },
    offer: (region, from) => openRegions.get(region)?.stage.offer(from) ?? null,
    isComplete: (region) => openRegions.get(region)?.state === 'complete',
    isCoarse: (region) => openRegions.get(region)?.region.entry.isCoarse ?? false,
    enter(region, from) {
      const [pending, open] = [pendingRegions.get(region), openRegions.get(region)];
      if (pending) pending.from = from;
      else if (!open) throw new Error(`region ${region} is not open`);
      else {
        open.stage.enter(from);
        open.shown = null;
      }
    },
    leave(region) {
      const open = openRegions.get(region);
      if (!open) return;
      open.stage.leave();
      open.shown = null;
    },
    morphState: (region) => openRegions.get(region)?.shown?.grown ?? null,
  };
  return {
    ...regions,
    find: (region: number): OpenRegion | null => openRegions.get(region) ?? null,
    /** Advances a region's picture by some seconds; pictures with a radius below `least` would fold. */
    advance(region: number, seconds: number, least: number): Shown | null {
      const open = openRegions.get(region);
      // The manifest of the region is not loaded yet.
      if (!open) return null;
      const before = lastRingOf(open.shown);
      open.shown = open.stage.advance(seconds, least);
      const ring = lastRingOf(open.shown);
      if (ring > before) markTimeline('shown', region, ring);
      return open.shown;
    },
    /** Loads the regions again that could not be loaded. */
    retry(): void {
      for (const open of [...openRegions.values()].filter(({ state }) => state === 'failed')) {
        const { grown } = open.shown ?? {};
        end(open);
        request(open.number, grown);
      }
      for (const [number, { hasFailed, from }] of pendingRegions) if (hasFailed) request(number, from);
    },
    get facts(): AtlasFacts {
      const isWaiting = [...pendingRegions.values()].some(({ hasFailed }) => !hasFailed);
      const areLoading = [...openRegions.values()].some(({ state }) => state === 'loading');
      const regions = [...openRegions.keys(), ...pendingRegions.keys()];
      return { regions, isLoading: isWaiting || areLoading, kept: workerMemory };
    },
    dispose(): void {
      for (const { stop } of pendingRegions.values()) stop.abort();
      pendingRegions.clear();
      for (const open of [...openRegions.values()]) end(open);
    },
  };
}

/** Whether a region can load its next ring. */
function isLoading(open: OpenRegion | undefined): boolean {
  return open?.state === 'loading' && !open.isIdle;
}

function asError(reason: unknown): Error {
  return reason instanceof Error ? reason : new Error(String(reason));
}

/** Returns the outermost ring in a picture; −1 for none. */
function lastRingOf(shown: Shown | null): number {
  return shown?.fading?.ring ?? shown?.ring ?? -1;
}
