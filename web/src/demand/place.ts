/** Region of a place that a server makes on demand, read from the streamed lines that announce its parts. */
import { choice, type Fields, integer, object, text } from '../bundle/checks';
import { arrivedRegion, type ArrivingRegion, firstRings } from '../bundle/contents';
import { BundleError } from '../bundle/error';
import type { FileEntry, Manifest, MapEntry, RingEntry } from '../bundle/manifest';
import { outlinedRing, readFiles, readManifest, readRing, tilesOf } from '../bundle/parse';

/** Progress of the server with a place. */
export type ServerProgress =
  /** Requested; coarse maps are arriving; complete. */
  | { readonly stage: 'asked' | 'coarse' | 'full' }
  /** Number of places that are made before this one. */
  | { readonly stage: 'waiting'; readonly before: number }
  /** The server is busy, and is asked again after some seconds. */
  | { readonly stage: 'busy'; readonly seconds: number };

export interface Listener {
  /** Files that can be fetched from now on. */
  readonly onFiles: (files: Readonly<Record<string, FileEntry>>) => void;
  readonly onProgress: (progress: ServerProgress) => void;
}

type Lines = AsyncIterator<unknown>;

const EVENTS = ['waiting', 'begin', 'ring', 'end', 'whole', 'failed'] as const;
const [COARSE, FULL] = [0, 1] as const;
const EMPTY_RING = { objects: 0, triangles: 0, geometry: null, parts: [], map: null } as const;

/**
 * Reads the lines of a place; resolves once its centre and rings are known, then continues reading. `last` is the last
 * requested ring, as text; null for all.
 */
export async function readPlace(lines: Lines, last: string | null, listener: Listener): Promise<ArrivingRegion> {
  const { event, fields } = await nextLine(lines, listener);
  if (event === 'whole') {
    const manifest = firstRings(last, readManifest(fields['manifest']));
    listener.onFiles(manifest.files);
    listener.onProgress({ stage: 'full' });
    return arrivedRegion(manifest, 0);
  }
  if (event !== 'begin') throw unexpected(event);
  const outline = firstRings(last, readManifest(fields['manifest'], outlinedRing));
  const place = createPlace(outline, listener);
  listener.onProgress({ stage: 'coarse' });
  readParts(lines, place, listener).catch(place.fail);
  return place.region;
}

async function readParts(lines: Lines, place: Place, listener: Listener): Promise<void> {
  for (;;) {
    const { event, fields } = await nextLine(lines, listener);
    if (event === 'begin') place.beginFull(readManifest(fields['manifest'], outlinedRing));
    else if (event === 'ring') place.add(fields);
    else if (event === 'end') {
      place.end();
      listener.onProgress({ stage: 'full' });
      return;
    } else throw unexpected(event);
  }
}

async function nextLine(lines: Lines, listener: Listener) {
  for (;;) {
    const { done, value } = await lines.next();
    if (done) throw new BundleError('the connection ended before the place was complete', 'network');
    const fields = object('parts', value);
    const event = choice('parts.event', fields['event'], EVENTS);
    if (event === 'failed') throw new BundleError(text('parts.reason', fields['reason']), 'place');
    if (event !== 'waiting') return { event, fields };
    listener.onProgress({ stage: 'waiting', before: integer('parts.before', fields['before'], 0) });
  }
}

type Place = ReturnType<typeof createPlace>;

function createPlace(outline: Manifest, listener: Listener) {
  const [entry] = outline.regions;
  if (!entry) throw new Error('a manifest has regions');
  const files: Record<string, FileEntry> = {};
  const count = entry.rings.length;
  // The last ring is repeated, with full-size maps.
  const rings: RingEntry[] = [...entry.rings, { ...EMPTY_RING, radius: entry.rings.at(-1)?.radius ?? 0 }];
  const region = { ...entry, rings, isCoarse: true };
  const manifest: Manifest = { ...outline, files, regions: [region] };
  const deferred = rings.map(() => createDeferred<RingEntry>());
  const arrived: RingEntry[] = [];
  const maps: MapEntry[] = [];
  let full: Manifest | null = null;

  function addFiles(entries: Readonly<Record<string, FileEntry>>): void {
    Object.assign(files, entries);
    listener.onFiles(entries);
  }

  function put(number: number, ring: RingEntry): void {
    rings[number] = arrived[number] = ring;
    deferred[number]?.resolve(ring);
  }

  addFiles(outline.files);
  return {
    region: {
      manifest,
      entry: region,
      ring(number: number): RingEntry | Promise<RingEntry> {
        const ring = arrived[number] ?? deferred[number]?.promise;
        if (!ring) throw new Error(`the place has no ring ${number}`);
        return ring;
      },
    },
    /** Full-size maps begin. */
    beginFull(fullOutline: Manifest): void {
      full = fullOutline;
      addFiles(fullOutline.files);
    },
    /** A ring of either stage is ready. */
    add(fields: Fields): void {
      const stage = integer('parts.stage', fields['stage'], COARSE, FULL);
      const number = integer('parts.ring', fields['ring'], 0);
      const layout = stage === COARSE ? outline.map : full?.map;
      if (!layout || (stage === FULL && number !== maps.length && number < count)) throw unexpected('ring');
      // Rings beyond the last requested one are ignored.
      if (number >= count) return;
      const ring = readRing(`ring ${number}`, fields['entry'], number, tilesOf(layout));
      addFiles(readFiles(object('parts.files', fields['files'])));
      if (stage === COARSE) put(number, ring);
      else if (ring.map) maps.push(ring.map);
    },
    end(): void {
      const [fullRegion] = full?.regions ?? [];
      if (!full || !fullRegion || maps.length !== count) throw unexpected('end');
      const sharper = { layout: full.map, range: fullRegion.range, maps };
      put(count, { ...EMPTY_RING, radius: rings[count]?.radius ?? 0, sharper });
    },
    fail(reason: unknown): void {
      for (const { reject } of deferred) reject(reason);
    },
  };
}

function unexpected(event: string): BundleError {
  return new BundleError(`parts: expected another event, got ${event}`);
}

/** A promise with the functions that settle it; a rejection without listeners is no unhandled error. */
function createDeferred<T>() {
  let [resolve, reject] = [(_: T): void => undefined, (_: unknown): void => undefined];
  const promise = new Promise<T>((...settle) => {
    [resolve, reject] = settle;
  });
  promise.catch(() => undefined);
  return { promise, resolve, reject };
}
