/** Types of a region's loading, and its requests for files, some of which are prefetched. */
import type { WebGLRenderer } from 'three';
import type { FileEntry, Manifest, RingEntry } from '../bundle/manifest';
import type { Fetch, Received } from '../bundle/source';
import type { FileData } from '../decode/messages';
import type { Store } from './buffers';
import type { Decoder } from './decoder';
import type { Shared } from './materials';
import type { PieceMesh } from './pieces';
import type { Programs } from './programs';
import type { Region } from './region';
import type { Uploads } from './uploads';

export interface Loading {
  readonly renderer: WebGLRenderer;
  readonly shared: Shared;
  readonly store: Store;
  readonly uploads: Uploads;
  /** Workers for geometry and for maps; the latter stores the state of each region's maps. */
  readonly geometry: Decoder;
  readonly maps: Decoder;
  readonly fetch: Fetch;
  readonly programs: Programs;
  readonly warm: (meshes: readonly PieceMesh[]) => void;
}

/** Loading of one region. */
export interface RegionLoading {
  /** Manifest of the region's bundle. */
  readonly manifest: Manifest;
  readonly region: Region;
  /** Number of the region. */
  readonly number: number;
  /** Called with each ring that can be shown. */
  readonly arrived: (ring: number) => void;
  /** Called with the number of received bytes, and of bytes of files already loaded. */
  readonly received: Received;
  /** Resolves to a ring when its files can be fetched and it is this region's turn. */
  readonly turn: (ring: number, signal: AbortSignal) => Promise<RingEntry>;
  /** Waits until the cube of an older map may be overwritten: it is in use during a cross-fade. */
  readonly mayReplace: (ring: number) => Promise<void>;
  readonly signal: AbortSignal;
}

export interface Job extends Loading, RegionLoading {
  readonly prefetch: Prefetch;
  /** Names of parts that the region has requested, or shares with other regions. */
  readonly requested: Set<string>;
}

export function filesOf(job: Job, names: string | readonly string[] | null): Promise<FileData[]> {
  const list = names === null ? [] : typeof names === 'string' ? [names] : names;
  return Promise.all(list.map((name) => fileOf(job, name)));
}

export async function fileOf({ prefetch, manifest, signal }: Job, name: string): Promise<FileData> {
  const described: FileEntry | undefined = manifest.files[name];
  if (!described) throw new Error(`${name} is not listed in the manifest`);
  return { name, data: await prefetch.fetch(name, signal), bytes: described.bytes, sha256: described.sha256 };
}

/** Greatest number of prefetched bytes that are not requested yet. */
const MAX_PREFETCH_BYTES = 16 * 2 ** 20;

/** Prefetched files, so that the network does not wait for decoding and uploads. */
export type Prefetch = ReturnType<typeof createPrefetch>;

/** Creates the prefetcher; `sizeOf` returns the bytes of a file. */
export function createPrefetch(fetch: Fetch, sizeOf: (name: string) => number, maxBytes = MAX_PREFETCH_BYTES) {
  const prefetched = new Map<string, Promise<ArrayBuffer>>();
  let bytes = 0;

  return {
    /** Returns the content of a file, possibly prefetched. */
    fetch(name: string, signal: AbortSignal): Promise<ArrayBuffer> {
      const content = prefetched.get(name);
      if (!content) return fetch(name, signal);
      prefetched.delete(name);
      bytes -= sizeOf(name);
      return content;
    },
    /** Prefetches files that will be requested next. */
    begin(names: readonly string[], signal: AbortSignal): void {
      for (const name of names) {
        if (prefetched.has(name) || bytes + sizeOf(name) > maxBytes) continue;
        const content = fetch(name, signal);
        // A request for the file reports the error.
        content.catch(() => undefined);
        prefetched.set(name, content);
        bytes += sizeOf(name);
      }
    },
    /** Number of prefetched bytes. */
    get bytes(): number {
      return bytes;
    },
  };
}
