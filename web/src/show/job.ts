/** The loading of a region: its means, its course, and the files that it asks for. */
import type { WebGLRenderer } from 'three';
import type { Described, Manifest, RingEntry } from '../bundle/manifest';
import type { Fetch, Received } from '../bundle/source';
import type { FileData } from '../decode/messages';
import type { Ahead } from './ahead';
import type { Decoder } from './decoder';
import type { Shared } from './materials';
import type { PieceMesh } from './pieces';
import type { Programs } from './programs';
import type { Region } from './region';
import type { Store } from './store';
import type { Uploads } from './uploads';

export interface Loading {
  readonly renderer: WebGLRenderer;
  readonly shared: Shared;
  readonly store: Store;
  readonly uploads: Uploads;
  /** Workers for geometry, and for maps: the latter keeps the state of each region's maps. */
  readonly geometry: Decoder;
  readonly maps: Decoder;
  readonly fetch: Fetch;
  readonly programs: Programs;
  readonly warm: (meshes: readonly PieceMesh[]) => void;
}

/** The loading of one region. */
export interface Course {
  /** Of the bundle that the region belongs to. */
  readonly manifest: Manifest;
  readonly region: Region;
  /** Number of the region. */
  readonly number: number;
  /** Is told of each ring that can be shown. */
  readonly arrived: (ring: number) => void;
  /** Is told of the bytes that come, and of those of files that are here. */
  readonly received: Received;
  /** A ring of the region, as soon as its files can be fetched and it is this region's turn. */
  readonly turn: (ring: number, signal: AbortSignal) => Promise<RingEntry>;
  /** Wait until the cube that holds an older map may be overwritten: it is shown while a cross-fade lasts. */
  readonly mayReplace: (ring: number) => Promise<void>;
  readonly signal: AbortSignal;
}

export interface Job extends Loading, Course {
  readonly ahead: Ahead;
  /** Names of parts that the region has asked for, or had from other regions. */
  readonly had: Set<string>;
}

export function filesOf(job: Job, names: string | readonly string[] | null): Promise<FileData[]> {
  const list = names === null ? [] : typeof names === 'string' ? [names] : names;
  return Promise.all(list.map((name) => fileOf(job, name)));
}

export async function fileOf({ ahead, manifest, signal }: Job, name: string): Promise<FileData> {
  const described: Described | undefined = manifest.files[name];
  if (!described) throw new Error(`${name} is not listed in the manifest`);
  return { name, data: await ahead.fetch(name, signal), bytes: described.bytes, sha256: described.sha256 };
}
