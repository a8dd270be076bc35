/** Viewer of a tree: requests the cut for the camera and its views, and draws what is loaded. */
import { messageOf } from '../../base/errors';
import { type Camera, isSameCamera } from '../cut/camera';
import { Cells } from '../cut/cells';
import type { Cut, FromCutter, Settings, ToCutter } from '../cut/cut';
import type { Wanted } from '../decode/reader';
import type { Failure } from '../store/error';
import { GEOMETRY, type Layout, nameOf, subtreeOf, type Triple } from '../store/layout';
import type { Shard } from '../store/records';
import { Catalog } from './catalog';
import { Queue } from './queue';
import { type Readers, startReaders } from './readers';
import { type Facts, factsOf, NOTHING } from './facts';
import { type Choice, choose } from './stand_in';
import { type Graphics, startStock } from './start';
import type { Stock } from './stock';

export interface ViewerSettings {
  readonly base: URL;
  readonly scripts: { readonly cutter: URL; readonly reader: URL; readonly webgpu: URL };
  /** Views per cell, and the greatest width of their pixels in pixels of the picture. */
  readonly views: number;
  readonly error: number;
  /** Whether leaves too near for the resolution of their views are drawn as geometry. */
  readonly geometry: boolean;
  /** Degrees by which directions are raised before views are chosen. */
  readonly lift: number;
  /** Samples along each axis of a pixel. */
  readonly grid: number;
  /** Back end; null for the best one available. */
  readonly graphics: Graphics | null;
  /** Limit of bytes for views on the GPU, and a quarter of it for geometry; those of one picture may exceed it. */
  readonly bytes: number;
  readonly workers: number;
  opened(layout: Layout): void;
  received(bytes: number): void;
  failed(failure: Failure, isFatal: boolean): void;
  /** Called when the server answers again. */
  recovered(): void;
}

/** Concurrent requests per worker: some views are decoded while others are being received. */
const AT_ONCE = 6;
/** Milliseconds between pictures that change only by new views, and the share of the time that they may take. */
const [PAUSE, SHARE] = [50, 0.5] as const;

interface Tree {
  readonly cells: Cells;
  readonly stock: Stock;
  readonly graphics: Graphics;
}

export class Viewer {
  readonly #settings: ViewerSettings;
  readonly #cutter: Worker;
  readonly #queue: Queue<Wanted>;
  /** Names of leaves whose geometry cannot be drawn. */
  readonly #without = new Set<string>();
  readonly #catalog = new Catalog();
  #tree: Tree | null = null;
  #readers: Readers | null = null;
  #cut: Cut | null = null;
  #base: Cut | null = null;
  #camera: Camera | null = null;
  /** Whether a cut is requested from the worker and has not arrived. */
  #isAsked = false;
  #isStale = false;
  /** Whether the camera has changed since the last picture; whether its content has. */
  #hasMoved = true;
  #isDirty = true;
  /** Begin and end of the last picture, milliseconds. */
  #begin = 0;
  #end = 0;
  #isDrawing = false;
  #facts: Omit<Facts, 'unhidden'> = NOTHING;

  constructor(readonly canvas: HTMLCanvasElement, settings: ViewerSettings) {
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

  /** Sets the camera; returns whether a picture was drawn: not if the last one is current or unfinished. */
  frame(camera: Camera): boolean {
    if (!this.#tree) return false;
    if (!this.#camera || !isSameCamera(this.#camera, camera)) {
      this.#camera = camera;
      this.#isStale = this.#hasMoved = true;
    }
    if (this.#isStale && !this.#isAsked) this.#look(camera);
    // Failed views may be due for a retry.
    this.#queue.fill();
    if (!this.#cut || !this.#isDone(this.#tree.stock)) return false;
    const isDue = performance.now() - this.#end >= Math.max(PAUSE, this.drawMs / SHARE - this.drawMs);
    if (!(this.#hasMoved || (this.#isDirty && (isDue || this.#queue.waiting === 0)))) return false;
    this.#draw(camera);
    return true;
  }

  get facts(): Facts {
    return { ...this.#facts, unhidden: this.#tree?.stock.unhidden ?? null };
  }

  /** Duration of the last picture, milliseconds. */
  get drawMs(): number {
    return Math.max(this.#end - this.#begin, 0);
  }

  /** Draws the last picture again; returns the milliseconds until the GPU has finished it. */
  async time(): Promise<number> {
    if (!this.#camera || !this.#tree) return 0;
    const { stock } = this.#tree;
    if (!stock.isDone) await stock.finish();
    this.#draw(this.#camera);
    const begin = this.#begin;
    await stock.finish();
    return performance.now() - begin;
  }

  /** Whether the GPU has finished the last picture: otherwise pictures would queue up. */
  #isDone(stock: Stock): boolean {
    if (!this.#isDrawing) return true;
    if (!stock.isDone) return false;
    this.#end = performance.now();
    this.#isDrawing = false;
    return true;
  }

  /** Requests everything that failed again. */
  retry(): void {
    this.#without.clear();
    this.#queue.retry();
    this.#tell({ kind: 'retry' });
  }

  #look(camera: Camera): void {
    const { views, error, geometry, lift } = this.#settings;
    const settings: Settings = { views, error, isAround: false, geometry, lift };
    [this.#isAsked, this.#isStale] = [true, false];
    this.#tell({ kind: 'look', camera, settings });
  }

  #hear(message: FromCutter): void {
    switch (message.kind) {
      case 'opened':
        this.#open(message.layout, message.shards, message.geometry).catch((reason) =>
          this.#settings.failed({ kind: 'other', message: messageOf(reason) }, true),
        );
        break;
      case 'learned':
        this.#tree?.cells.add(message.subtree);
        this.#catalog.add(message.subtree.shards, message.subtree.geometry);
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

  async #open(layout: Layout, shards: readonly Shard[], geometry: readonly Shard[]): Promise<void> {
    const { scripts, workers, base, bytes } = this.#settings;
    const stock = await this.#stock(layout, bytes);
    if (!stock) return;
    this.#tree = { cells: new Cells(layout), ...stock };
    this.#catalog.add(shards, geometry);
    this.#readers = startReaders(scripts.reader, workers, base, layout, {
      view: (id, layers) => {
        const found = this.#queue.done(id);
        if (found) this.#add((stock) => stock.addView(found.level, found.place, found.direction, layers));
        this.#isDirty = true;
        this.#queue.fill();
      },
      leaf: (id, pieces) => {
        const found = this.#queue.done(id);
        if (found) this.#add((stock) => stock.addLeaf(found.place, pieces));
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

  /** Uploads data to the GPU, which may have no memory for it. */
  #add(add: (stock: Stock) => void): void {
    try {
      if (this.#tree) add(this.#tree.stock);
    } catch (reason) {
      this.#settings.failed({ kind: 'other', message: messageOf(reason) }, false);
    }
  }

  /** Returns the stock of the first back end that works; null if none does. */
  async #stock(layout: Layout, bytes: number): Promise<Pick<Tree, 'stock' | 'graphics'> | null> {
    const failed = (message: string, isFatal: boolean): void =>
      this.#settings.failed({ kind: 'other', message }, isFatal);
    try {
      const { graphics, scripts } = this.#settings;
      return await startStock(this.canvas, layout, { graphics, script: scripts.webgpu, bytes, failed });
    } catch (reason) {
      failed(messageOf(reason), true);
      return null;
    }
  }

  #choose(cut: Cut): Choice {
    const { cells, stock } = this.#tree as Tree;
    const there = (level: number, place: Triple): readonly number[] => stock.there(level, place);
    return choose(cut, cells, there, this.#settings.views, (place) => this.#nearOf(place));
  }

  #nearOf(place: Triple): 'there' | 'coming' | 'never' {
    const { cells, stock } = this.#tree as Tree;
    if (this.#without.has(nameOf(0, place))) return 'never';
    if (stock.hasLeaf(place)) return 'there';
    const { tier, place: subtree } = subtreeOf(cells.layout, 0, place);
    return cells.knows(tier, subtree) && this.#catalog.filesOf(cells.layout, place).length === 0 ? 'there' : 'coming';
  }

  #draw(camera: Camera): void {
    if (!this.#tree || !this.#cut) return;
    const { cells, stock, graphics } = this.#tree;
    this.#hasMoved = this.#isDirty = false;
    this.#begin = performance.now();
    this.#isDrawing = true;
    const choice = this.#choose(this.#cut);
    const needed = this.#cut.leaves.flatMap(({ place }) => [place, ...cells.guestsOf(place)]);
    const drawn = stock.draw(choice, camera, this.#settings.grid, {
      cells: new Set(this.#base?.cells.map(({ level, place }) => nameOf(level, place))),
      leaves: new Set(needed.map((place) => nameOf(0, place))),
    });
    const [{ waiting }, isCurrent] = [this.#queue, !this.#isAsked && !this.#isStale];
    const isComplete = isCurrent && waiting === 0 && this.#cut.unknown.length === 0;
    this.#facts = { ...factsOf(choice, drawn, stock), waiting, isComplete, graphics };
  }

  /** Requests missing views: coarse cells in the picture, then the cut, nearest first, then other coarse cells. */
  #want(): void {
    if (!this.#tree) return;
    const { cells } = this.#tree;
    const wanted = new Map<string, Wanted>();
    const coarse = (isInPicture: boolean): Cut | null =>
      this.#base && { ...this.#base, cells: this.#base.cells.filter((cell) => cell.isInPicture === isInPicture) };
    for (const cut of [coarse(true), this.#cut, coarse(false)]) {
      if (!cut) continue;
      const { coming, missing } = this.#choose(cut);
      // Leaves are small files that cover most of the picture.
      const leaves = coming.map((place) => ({ level: 0, place, direction: GEOMETRY }));
      for (const { level, place, direction } of [...leaves, ...missing]) {
        const name = `${nameOf(level, place)}/${direction}`;
        if (!wanted.has(name)) wanted.set(name, this.#catalog.request(cells, level, place, direction));
      }
    }
    this.#queue.want(wanted);
  }

  #tell(message: ToCutter): void {
    this.#cutter.postMessage(message);
  }
}
