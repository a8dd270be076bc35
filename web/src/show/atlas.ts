/** The regions that are open: what is loaded of each, and what it would show. */
import { bytesOf, filesOfRegion } from '../bundle/contents';
import type { Kept } from '../decode/messages';
import type { Grown } from './growth';
import type { Regions } from './journey';
import { loadRegion, type Loading } from './loader';
import { createRegion, type Region } from './region';
import { createStage, type Manner, type Shown, type Stage } from './stage';
import { tell } from './told';

export interface AtlasSettings {
  readonly loading: Loading;
  readonly manner: Manner;
  /** Loading a region has failed. */
  readonly failed: (region: number, reason: Error) => void;
}

/** A region that is open. */
export interface Open {
  readonly number: number;
  readonly region: Region;
  readonly stage: Stage;
  readonly stop: AbortController;
  /** Last ring that is there; −1 before ring 0. */
  arrived: number;
  /** Its picture now, or the last one. */
  shown: Shown | null;
  /** Bytes of its files that are here, and of all of them. */
  received: number;
  readonly expected: number;
  state: 'loading' | 'complete' | 'failed';
}

export interface Holding {
  /** Numbers of the regions that are open. */
  readonly regions: readonly number[];
  readonly isLoading: boolean;
  /** Buffers and maps of the workers when the last region was closed. */
  readonly kept: readonly Kept[];
}

export interface Atlas extends Regions {
  find(region: number): Open | null;
  /** Show a region some seconds later; smaller radii than `least` would fold. */
  advance(region: number, seconds: number, least: number): Shown | null;
  /** Load again what failed. */
  retry(): void;
  readonly holding: Holding;
  dispose(): void;
}

export function createAtlas({ loading, manner, failed }: AtlasSettings): Atlas {
  const { manifest, renderer, store } = loading;
  const nearShare = manifest.morph.near_share;
  const opens = new Map<number, Open>();
  let order: readonly number[] = [];
  let waiting: { region: number; done: () => void }[] = [];
  let kept: readonly Kept[] = [];

  /** Let the first region that is not complete go on. */
  function call(): void {
    const next = order.find((region) => opens.get(region)?.state === 'loading');
    const called = waiting.filter(({ region }) => region === next);
    waiting = waiting.filter(({ region }) => region !== next);
    for (const { done } of called) done();
  }

  function turn(region: number, signal: AbortSignal): Promise<void> {
    return new Promise((done, refuse) => {
      signal.addEventListener('abort', () => refuse(signal.reason as Error), { once: true });
      waiting.push({ region, done });
      call();
    });
  }

  function begin(number: number): void {
    const entry = manifest.regions[number];
    if (!entry) throw new Error(`there is no region ${number}`);
    const radii = entry.rings.slice(1).map((ring) => ring.radius);
    const stage = createStage({ ...manifest.growth, radii, nearShare }, manner);
    const region = createRegion(renderer, entry, manifest.map.face_size, store, loading.shared);
    const stop = new AbortController();
    const open: Open = {
      number,
      region,
      stage,
      stop,
      arrived: -1,
      shown: null,
      received: 0,
      expected: bytesOf(manifest, filesOfRegion(manifest, entry)),
      state: 'loading',
    };
    opens.set(number, open);
    const ended = (state: Open['state']): void => {
      open.state = state;
      call();
    };
    loadRegion(loading, {
      region,
      number,
      arrived(ring) {
        open.arrived = ring;
        tell('arrived', number, ring);
        stage.arrive(ring);
      },
      received: (bytes) => {
        open.received += bytes;
      },
      turn: (signal) => turn(number, signal),
      mayReplace: (ring) => stage.replaceable(ring),
      signal: stop.signal,
    }).then(
      () => ended('complete'),
      (reason: unknown) => {
        if (stop.signal.aborted) return;
        ended('failed');
        failed(number, reason instanceof Error ? reason : new Error(String(reason)));
      },
    );
  }

  function end(open: Open): void {
    opens.delete(open.number);
    open.stop.abort();
    open.region.dispose();
    waiting = waiting.filter(({ region }) => region !== open.number);
    const needed = [...opens.values()].flatMap(({ region }) => [...filesOfRegion(manifest, region.entry)]);
    const request = { kind: 'forget', buffers: store.keep(new Set(needed)), region: open.number } as const;
    Promise.all([loading.geometry(request), loading.maps(request)]).then(
      (answers) => {
        kept = answers;
      },
      // A worker that stopped is told of by what waits for it.
      () => undefined,
    );
  }

  function found(region: number): Open {
    const open = opens.get(region);
    if (!open) throw new Error(`region ${region} is not open`);
    return open;
  }

  return {
    find: (region) => opens.get(region) ?? null,
    open(region) {
      if (!opens.has(region)) begin(region);
    },
    close(region) {
      const open = opens.get(region);
      if (open) end(open);
    },
    prefer(next) {
      order = next;
      call();
    },
    offer: (region, from) => opens.get(region)?.stage.offer(from) ?? null,
    isComplete: (region) => opens.get(region)?.state === 'complete',
    enter(region, from) {
      const open = found(region);
      open.stage.enter(from);
      open.shown = null;
    },
    leave(region) {
      const open = opens.get(region);
      open?.stage.leave();
      if (open) open.shown = null;
    },
    grown: (region): Grown | null => opens.get(region)?.shown?.grown ?? null,
    advance(region, seconds, least) {
      const open = found(region);
      const before = lastOf(open.shown);
      open.shown = open.stage.advance(seconds, least);
      const ring = lastOf(open.shown);
      if (ring > before) tell('shown', region, ring);
      return open.shown;
    },
    retry() {
      for (const open of [...opens.values()].filter(({ state }) => state === 'failed')) {
        const { grown } = open.shown ?? {};
        end(open);
        begin(open.number);
        if (grown) found(open.number).stage.enter(grown);
      }
    },
    get holding() {
      const isLoading = [...opens.values()].some(({ state }) => state === 'loading');
      return { regions: [...opens.keys()], isLoading, kept };
    },
    dispose() {
      for (const open of [...opens.values()]) end(open);
    },
  };
}

/** The last ring in a picture; −1 for none. */
function lastOf(shown: Shown | null): number {
  return shown?.fading?.ring ?? shown?.ring ?? -1;
}
