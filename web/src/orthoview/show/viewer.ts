/** Draws a tree for wherever the viewer is: asks for the cut and its views, and shows what has come. */
import { Cells, nameOf } from '../cut/cells';
import type { Camera } from '../cut/camera';
import type { Cut, Settings } from '../cut/cut';
import type { FromCutter, ToCutter } from '../cut/messages';
import type { Wanted } from '../decode/reader';
import { Drawer, type Item, type Uploaded } from '../draw/drawer';
import type { Mesh } from '../draw/meshes';
import { modelOf } from '../splats/sight';
import type { Failure } from '../store/error';
import {
  arrayOf,
  channelsOf,
  GEOMETRY,
  geometryOf,
  type Layout,
  overlay,
  shardOf,
  subtreeOf,
  type Triple,
} from '../store/layout';
import type { Shard } from '../store/records';
import { Queue } from './queue';
import { type Readers, startReaders } from './readers';
import { Resident } from './resident';
import { type Choice, choose } from './stand_in';

export interface ViewerSettings {
  readonly base: URL;
  readonly scripts: { readonly cutter: URL; readonly reader: URL };
  /** Views of a cell, and the greatest width of their pixels in pixels of the picture. */
  readonly views: number;
  readonly error: number;
  /** Whether leaves that are nearer than their views are fine are drawn as geometry. */
  readonly geometry: boolean;
  /** Samples along each axis of a pixel. */
  readonly grid: number;
  /** Bytes of the GPU that views may take, and a quarter of it geometry; those of one picture may take more. */
  readonly bytes: number;
  readonly workers: number;
  opened(layout: Layout): void;
  received(bytes: number): void;
  failed(failure: Failure, isFatal: boolean): void;
  /** The server answers again. */
  recovered(): void;
}

/** Views that are asked for at once, for each worker: while some are decoded, others are on their way. */
const AT_ONCE = 6;
/** Folder of a later generation. */
const GENERATION = /^nearfar\/generations\/\d+\//;
/** Milliseconds between pictures that only new views change, and the part of the time that these pictures may take. */
const [PAUSE, SHARE] = [50, 0.5] as const;

export interface Facts {
  /** Views that the picture shows, those among them that stand in for others, and those that are waited for. */
  readonly views: number;
  readonly standIns: number;
  readonly waiting: number;
  /** Cells of which nothing is there. */
  readonly holes: number;
  readonly splats: number;
  /** Leaves that are drawn as geometry, with their guests, and their triangles. */
  readonly leaves: number;
  readonly triangles: number;
  readonly calls: number;
  /** Bytes and views on the GPU. */
  readonly bytes: number;
  readonly kept: number;
  /** All views of the cut for this camera have come. */
  readonly isComplete: boolean;
}

const NOTHING: Facts = {
  views: 0,
  standIns: 0,
  waiting: 0,
  holes: 0,
  splats: 0,
  leaves: 0,
  triangles: 0,
  calls: 0,
  bytes: 0,
  kept: 0,
  isComplete: false,
};

interface Tree {
  readonly cells: Cells;
  readonly drawer: Drawer;
  readonly resident: Resident<Uploaded>;
  /** The geometry of leaves. */
  readonly near: Resident<Mesh>;
}

export class Viewer {
  readonly #settings: ViewerSettings;
  readonly #cutter: Worker;
  readonly #queue: Queue<Wanted>;
  readonly #shards = new Map<string, Shard>();
  /** Files of geometry by their paths below a generation's folder, the newest ones. */
  readonly #files = new Map<string, Shard>();
  /** Names of leaves whose geometry cannot be drawn. */
  readonly #without = new Set<string>();
  #tree: Tree | null = null;
  #readers: Readers | null = null;
  #cut: Cut | null = null;
  #base: Cut | null = null;
  #camera: Camera | null = null;
  /** The camera that the cut is for is on its way to the worker or back. */
  #isAsked = false;
  #isStale = false;
  /** The camera has changed since the last picture, or what it could show. */
  #hasMoved = true;
  #isDirty = true;
  /** When the last picture was begun and was there, milliseconds. */
  #begin = 0;
  #end = 0;
  #isDrawing = false;
  facts: Facts = NOTHING;

  constructor(
    readonly canvas: HTMLCanvasElement,
    settings: ViewerSettings,
  ) {
    this.#settings = settings;
    this.#cutter = new Worker(settings.scripts.cutter, { type: 'module' });
    this.#cutter.onmessage = ({ data }: MessageEvent<FromCutter>): void => this.#hear(data);
    this.#cutter.onerror = ({ message }): void =>
      settings.failed({ kind: 'other', message: `a worker stopped: ${message}` }, true);
    this.#queue = new Queue<Wanted>({
      atOnce: AT_ONCE * settings.workers,
      send: (id, wanted) => this.#readers?.read(id, wanted),
      cancel: (id) => this.#readers?.cancel(id),
      failed: (failure) => settings.failed(failure, false),
      recovered: settings.recovered,
      now: () => performance.now() / 1000,
    });
    this.#tell({ kind: 'open', base: settings.base.href });
  }

  /** Look from a camera; true if a picture was drawn, false if the last one still does or is being drawn. */
  frame(camera: Camera): boolean {
    if (!this.#tree) return false;
    if (!this.#camera || !isSame(this.#camera, camera)) {
      this.#camera = camera;
      this.#isStale = this.#hasMoved = true;
    }
    if (this.#isStale && !this.#isAsked) this.#look(camera);
    // Failed views may be due again.
    this.#queue.fill();
    if (!this.#cut || !this.#isDone(this.#tree.drawer)) return false;
    const isDue = performance.now() - this.#end >= Math.max(PAUSE, this.took / SHARE - this.took);
    if (!(this.#hasMoved || (this.#isDirty && (isDue || this.#queue.waiting === 0)))) return false;
    this.#draw(camera);
    return true;
  }

  /** Milliseconds that the last picture took. */
  get took(): number {
    return Math.max(this.#end - this.#begin, 0);
  }

  /** Draw the last picture again; the milliseconds until it is there. */
  time(): number {
    if (!this.#camera || !this.#tree) return 0;
    this.#draw(this.#camera);
    this.#tree.drawer.finish();
    return performance.now() - this.#begin;
  }

  /** Whether the graphics are done with the last picture: others would only pile up. */
  #isDone(drawer: Drawer): boolean {
    if (!this.#isDrawing) return true;
    if (!drawer.isDone) return false;
    this.#end = performance.now();
    this.#isDrawing = false;
    return true;
  }

  /** Ask again for all that failed. */
  retry(): void {
    this.#without.clear();
    this.#queue.retry();
    this.#tell({ kind: 'retry' });
  }

  #look(camera: Camera): void {
    const { views, error, geometry } = this.#settings;
    const settings: Settings = { views, error, isAround: false, geometry };
    [this.#isAsked, this.#isStale] = [true, false];
    this.#tell({ kind: 'look', camera, settings });
  }

  #hear(message: FromCutter): void {
    switch (message.kind) {
      case 'opened':
        this.#open(message.layout, message.shards, message.geometry);
        break;
      case 'learned':
        this.#tree?.cells.add(message.subtree);
        this.#know(message.subtree.shards, message.subtree.geometry);
        break;
      case 'base':
        this.#base = message.cut;
        break;
      case 'cut':
        this.#cut = message.cut;
        this.#isAsked = false;
        this.#isDirty = true;
        this.#want();
        break;
      case 'received':
        this.#settings.received(message.bytes);
        break;
      case 'failed':
        this.#settings.failed(message.failure, message.isFatal);
    }
  }

  #open(layout: Layout, shards: readonly Shard[], geometry: readonly Shard[]): void {
    const drawer = new Drawer(this.canvas, layout);
    const { scripts, workers, base, bytes } = this.#settings;
    this.#tree = {
      cells: new Cells(layout),
      drawer,
      resident: new Resident((layer) => drawer.drop(layer), bytes),
      near: new Resident((mesh) => drawer.meshes.drop(mesh), bytes / 4),
    };
    this.#know(shards, geometry);
    this.#readers = startReaders(scripts.reader, workers, base, layout, {
      view: (id, layers) => {
        const found = this.#queue.done(id);
        if (found) {
          const { level, place, direction } = found;
          const model = modelOf(layout, level, place, direction);
          const uploaded = layers.map((splats) => drawer.upload(model, splats));
          this.#tree?.resident.add(level, place, direction, uploaded);
        }
        this.#isDirty = true;
        this.#queue.fill();
      },
      leaf: (id, pieces) => {
        const found = this.#queue.done(id);
        const uploaded = found ? pieces.map((piece) => drawer.meshes.upload(piece)) : [];
        if (found) this.#tree?.near.add(0, found.place, GEOMETRY, uploaded);
        this.#isDirty = true;
        this.#queue.fill();
      },
      failed: (id, failure) => {
        const job = this.#queue.failed(id, failure);
        if (job?.direction !== GEOMETRY) return;
        this.#without.add(nameOf(0, job.place));
        this.#isDirty = true;
        this.#want();
      },
      cancelled: (id) => this.#queue.cancelled(id),
      received: this.#settings.received,
    });
    this.#settings.opened(layout);
  }

  #know(shards: readonly Shard[], geometry: readonly Shard[]): void {
    for (const shard of shards) this.#shards.set(shard[0], shard);
    for (const file of geometry) {
      const name = file[0].replace(GENERATION, '');
      if (!this.#files.has(name)) this.#files.set(name, file);
    }
  }

  #choose(cut: Cut): Choice {
    const { cells, resident } = this.#tree as Tree;
    const there = (level: number, place: Triple): readonly number[] => resident.there(level, place);
    return choose(cut, cells, there, this.#settings.views, (place) => this.#nearOf(place));
  }

  #nearOf(place: Triple): 'there' | 'coming' | 'never' {
    const { cells, near } = this.#tree as Tree;
    if (this.#without.has(nameOf(0, place))) return 'never';
    if (near.there(0, place).length > 0) return 'there';
    const { tier, place: subtree } = subtreeOf(cells.layout, 0, place);
    return cells.knows(tier, subtree) && this.#filesOf(place).length === 0 ? 'there' : 'coming';
  }

  /** The files of a leaf's geometry, as far as it has some. */
  #filesOf(place: Triple): Shard[] {
    const { layout } = (this.#tree as Tree).cells;
    const files = geometryOf(layout, place).map((name) => this.#files.get(name));
    return files.filter((file) => file !== undefined && file[1] > 0) as Shard[];
  }

  #draw(camera: Camera): void {
    if (!this.#tree || !this.#cut) return;
    const { drawer, resident, near } = this.#tree;
    this.#hasMoved = this.#isDirty = false;
    this.#begin = performance.now();
    this.#isDrawing = true;
    const choice = this.#choose(this.#cut);
    resident.begin();
    near.begin();
    const meshes = choice.near.flatMap((place) => near.use(0, place, GEOMETRY));
    const items = choice.shown.flatMap(({ level, place, direction, box }): Item[] =>
      resident.use(level, place, direction).map((layer) => ({ layer, box })),
    );
    const { splats, triangles, calls } = drawer.draw(meshes, items, camera, this.#settings.grid);
    const kept = new Set(this.#base?.cells.map(({ level, place }) => nameOf(level, place)));
    resident.trim((level, place) => kept.has(nameOf(level, place)));
    const { cells } = this.#tree;
    const needed = this.#cut.leaves.flatMap(({ place }) => [place, ...cells.guestsOf(place)]);
    const names = new Set(needed.map((place) => nameOf(0, place)));
    near.trim((level, place) => names.has(nameOf(level, place)));
    const [{ waiting }, isCurrent] = [this.#queue, !this.#isAsked && !this.#isStale];
    this.facts = {
      views: choice.shown.length,
      standIns: choice.shown.filter(({ box }) => box !== null).length,
      waiting,
      holes: choice.holes,
      splats,
      leaves: choice.near.length,
      triangles,
      calls,
      bytes: resident.bytes + near.bytes,
      kept: resident.count,
      isComplete: isCurrent && waiting === 0 && this.#cut.unknown.length === 0,
    };
  }

  /** Ask for what is missing: coarse cells of the picture, then the cut, the nearest first, then other coarse cells. */
  #want(): void {
    const wanted = new Map<string, Wanted>();
    const coarse = (isInPicture: boolean): Cut | null =>
      this.#base && { ...this.#base, cells: this.#base.cells.filter((cell) => cell.isInPicture === isInPicture) };
    for (const cut of [coarse(true), this.#cut, coarse(false)]) {
      if (!cut) continue;
      const { coming, missing } = this.#choose(cut);
      // Leaves have few bytes, and take the most of the picture.
      const leaves = coming.map((place) => ({ level: 0, place, direction: GEOMETRY }));
      for (const { level, place, direction } of [...leaves, ...missing]) {
        const name = `${nameOf(level, place)}/${direction}`;
        if (!wanted.has(name)) wanted.set(name, this.#wantedOf(level, place, direction));
      }
    }
    this.#queue.want(wanted);
  }

  #wantedOf(level: number, place: Triple, direction: number): Wanted {
    const { cells } = this.#tree as Tree;
    if (direction === GEOMETRY) return { level, place, direction, generation: 0, shards: this.#filesOf(place) };
    const generation = cells.at(level, place)?.generation ?? 0;
    const shards = channelsOf(cells.layout).map((channel) => {
      const array = arrayOf(cells.layout, level, direction, channel);
      return this.#shards.get(overlay(generation) + shardOf(cells.layout, level, place, array));
    });
    return { level, place, direction, generation, shards: shards.filter((shard) => shard !== undefined) };
  }

  #tell(message: ToCutter): void {
    this.#cutter.postMessage(message);
  }
}

function isSame(one: Camera, other: Camera): boolean {
  const numbers = ({ position, right, up, fov, width, height }: Camera): number[] => [
    ...position,
    ...right,
    ...up,
    ...Object.values(fov),
    width,
    height,
  ];
  const others = numbers(other);
  return numbers(one).every((value, at) => value === others[at]);
}
