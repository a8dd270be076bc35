/** Region that a server makes on demand, read from a stream of lines that announce its parts as they become ready. */
import { choice, type Fields, integer, object, text } from '../bundle/checks';
import { completeRegion, type ArrivingRegion, limitRings } from '../bundle/contents';
import { BundleError } from '../bundle/error';
import type { FileEntry, Manifest, MapEntry, RingEntry } from '../bundle/manifest';
import { readRingOutline, readFiles, readManifest, readRing, tilesOf } from '../bundle/parse';

/** Progress of the server with a place. */
export type ServerProgress =
  /** The region is requested, its coarse maps arrive, or it is complete. */
  | { readonly stage: 'requested' | 'coarse' | 'full' }
  /** The server makes `before` other places first. */
  | { readonly stage: 'waiting'; readonly before: number }
  /** The server is busy, and the request is repeated after some seconds. */
  | { readonly stage: 'busy'; readonly seconds: number };

export interface Listener {
  /** Called with files that can be fetched from now on. */
  readonly onFiles: (files: Readonly<Record<string, FileEntry>>) => void;
  readonly onProgress: (progress: ServerProgress) => void;
}

type Lines = AsyncIterator<unknown>;

const EVENTS = ['waiting', 'begin', 'ring', 'end', 'whole', 'failed'] as const;
const [COARSE, FULL] = [0, 1] as const;
const EMPTY_RING = { objects: 0, triangles: 0, geometry: null, parts: [], map: null } as const;

/**
 * Reads the lines of a place; resolves when its centre and the number of rings are known, and continues to read. `last`
 * is the number of the last requested ring, as text; null for all rings.
 */
export async function readPlace(lines: Lines, last: string | null, listener: Listener): Promise<ArrivingRegion> {
  const { event, fields } = await nextLine(lines, listener);
  if (event === 'whole') {
    const manifest = limitRings(last, readManifest(fields['manifest']));
    listener.onFiles(manifest.files);
    listener.onProgress({ stage: 'full' });
    return completeRegion(manifest, 0);
  }
  if (event !== 'begin') throw unexpectedEvent(event);
  const outline = limitRings(last, readManifest(fields['manifest'], readRingOutline));
  const place = createPlace(outline, listener);
  listener.onProgress({ stage: 'coarse' });
  readParts(lines, place, listener).catch(place.fail);
  return place.region;
}

async function readParts(lines: Lines, place: Place, listener: Listener): Promise<void> {
  for (;;) {
    const { event, fields } = await nextLine(lines, listener);
    if (event === 'begin') place.beginFull(readManifest(fields['manifest'], readRingOutline));
    else if (event === 'ring') place.add(fields);
    else if (event === 'end') {
      place.end();
      listener.onProgress({ stage: 'full' });
      return;
    } else throw unexpectedEvent(event);
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
    /** Begins the full-size maps. */
    beginFull(fullOutline: Manifest): void {
      full = fullOutline;
      addFiles(fullOutline.files);
    },
    /** Adds a ring of the coarse or of the full-size maps. */
    add(fields: Fields): void {
      const stage = integer('parts.stage', fields['stage'], COARSE, FULL);
      const number = integer('parts.ring', fields['ring'], 0);
      const layout = stage === COARSE ? outline.map : full?.map;
      if (!layout || (stage === FULL && number !== maps.length && number < count)) throw unexpectedEvent('ring');
      // Rings beyond the last requested one are ignored.
      if (number >= count) return;
      const ring = readRing(`ring ${number}`, fields['entry'], number, tilesOf(layout));
      addFiles(readFiles(object('parts.files', fields['files'])));
      if (stage === COARSE) put(number, ring);
      else if (ring.map) maps.push(ring.map);
    },
    end(): void {
      const [fullRegion] = full?.regions ?? [];
      if (!full || !fullRegion || maps.length !== count) throw unexpectedEvent('end');
      const sharper = { layout: full.map, range: fullRegion.range, maps };
      put(count, { ...EMPTY_RING, radius: rings[count]?.radius ?? 0, sharper });
    },
    fail(reason: unknown): void {
      for (const { reject } of deferred) reject(reason);
    },
  };
}

function unexpectedEvent(event: string): BundleError {
  return new BundleError(`parts: expected another event, got ${event}`);
}

/** Promise with the functions that settle it; a rejection that nobody awaits is not reported as unhandled. */
function createDeferred<T>() {
  let [resolve, reject] = [(_: T): void => undefined, (_: unknown): void => undefined];
  const promise = new Promise<T>((...settle) => {
    [resolve, reject] = settle;
  });
  promise.catch(() => undefined);
  return { promise, resolve, reject };
}
