/** Viewer of a tree: requests the cut for the camera and its views, and draws what is loaded. */
import { messageOf } from '../../base/errors';
import type { Camera } from '../cut/camera';
import { Cells, type Cut, type FromCutter, type Opened, type Settings, type ToCutter } from '../cut/cut';
import type { FromReader, ViewRequest } from '../decode/reader';
import type { Failure } from '../store/error';
import { GEOMETRY, type Layout, nameOf, subtreeOf, type Triple, type ViewKey, viewName } from '../store/layout';
import { Catalog } from './catalog';
import { Queue } from './queue';
import { type Readers, startReaders } from './readers';
import { type Choice, choose, type GeometryState } from './stand_in';
import { startStock } from './start';
import { type Facts, factsOf, type Graphics, INITIAL_FACTS, type Stock } from './stock';

export interface ViewerSettings extends Omit<Settings, 'isAround'> {
  readonly base: URL;
  readonly scripts: { readonly cutter: URL; readonly reader: URL; readonly webgpu: URL };
  /** Samples along each axis of a pixel. */
  readonly grid: number;
  /** Back end; null for the best one available. */
  readonly graphics: Graphics | null;
  /** Limit of bytes for views on the GPU, and a quarter of it for geometry; those of one picture may exceed it. */
  readonly bytes: number;
  readonly workers: number;
  onOpen(layout: Layout): void;
  onReceived(bytes: number): void;
  onFailure(failure: Failure, isFatal: boolean): void;
  /** Called when the server answers again. */
  onRecovered(): void;
}

/** Concurrent requests per worker: some views are decoded while others are being received. */
const REQUESTS_PER_WORKER = 6;
/** Least milliseconds between pictures that change only by new views. */
const MIN_PAUSE_MS = 50;
/** Greatest share of the time that such pictures may take. */
const MAX_DRAWING_SHARE = 0.5;

interface Tree {
  readonly cells: Cells;
  readonly stock: Stock;
  readonly graphics: Graphics;
}

export class Viewer {
  readonly #settings: ViewerSettings;
  readonly #cutter: Worker;
  readonly #queue: Queue<ViewRequest>;
  /** Names of leaves whose geometry cannot be drawn. */
  readonly #undrawable = new Set<string>();
  readonly #catalog = new Catalog();
  #tree: Tree | null = null;
  #readers: Readers | null = null;
  #cut: Cut | null = null;
  #baseCut: Cut | null = null;
  #camera: Camera | null = null;
  /** Whether a cut is requested from the worker and has not arrived. */
  #isCutRequested = false;
  #isCutStale = false;
  /** Whether the camera has changed since the last picture; whether its content has. */
  #hasMoved = true;
  #isDirty = true;
  /** Start and end time of the last picture, milliseconds. */
  #begin = 0;
  #end = 0;
  #isDrawing = false;
  #facts: Omit<Facts, 'unhidden'> = INITIAL_FACTS;

  constructor(readonly canvas: HTMLCanvasElement, settings: ViewerSettings) {
    this.#settings = settings;
    this.#cutter = new Worker(settings.scripts.cutter, { type: 'module' });
    this.#cutter.onmessage = ({ data }: MessageEvent<FromCutter>): void => this.#hearCutter(data);
    this.#cutter.onerror = ({ message }): void =>
      settings.onFailure({ kind: 'other', message: `a worker stopped: ${message}` }, true);
    this.#queue = new Queue<ViewRequest>({
      maxRunning: REQUESTS_PER_WORKER * settings.workers,
      send: (id, request) => this.#readers?.read(id, request),
      cancel: (id) => this.#readers?.cancel(id),
      onFailure: (failure) => settings.onFailure(failure, false),
      onRecovered: settings.onRecovered,
      now: () => performance.now() / 1000,
    });
    this.#tell({ kind: 'open', base: settings.base.href });
  }

  /** Sets the camera; returns whether a picture was drawn: not if the last one is current or unfinished. */
  frame(camera: Camera): boolean {
    if (!this.#tree) return false;
    if (JSON.stringify(this.#camera) !== JSON.stringify(camera)) {
      this.#camera = camera;
      this.#isCutStale = this.#hasMoved = true;
    }
    if (this.#isCutStale && !this.#isCutRequested) this.#requestCut(camera);
    // Failed views may be due for a retry.
    this.#queue.fill();
    if (!this.#cut || !this.#isDone(this.#tree.stock)) return false;
    const pause = Math.max(MIN_PAUSE_MS, this.drawMs / MAX_DRAWING_SHARE - this.drawMs);
    const isDue = performance.now() - this.#end >= pause;
    if (!(this.#hasMoved || (this.#isDirty && (isDue || this.#queue.waiting === 0)))) return false;
    this.#draw(camera);
    return true;
  }

  get facts(): Facts {
    return { ...this.#facts, unhidden: this.#tree?.stock.drawer.unhidden ?? null };
  }

  /** Duration of the last picture, milliseconds. */
  get drawMs(): number {
    return Math.max(this.#end - this.#begin, 0);
  }

  /** Draws the last picture again; returns the milliseconds until the GPU has finished it. */
  async time(): Promise<number> {
    if (!this.#camera || !this.#tree) return 0;
    const { drawer } = this.#tree.stock;
    if (!drawer.isDone) await drawer.finish();
    this.#draw(this.#camera);
    const begin = this.#begin;
    await drawer.finish();
    return performance.now() - begin;
  }

  /** Whether the GPU has finished the last picture: otherwise pictures would queue up. */
  #isDone({ drawer }: Stock): boolean {
    if (!this.#isDrawing) return true;
    if (!drawer.isDone) return false;
    this.#end = performance.now();
    this.#isDrawing = false;
    return true;
  }

  /** Requests everything that failed again. */
  retry(): void {
    this.#undrawable.clear();
    this.#queue.retry();
    this.#tell({ kind: 'retry' });
  }

  #requestCut(camera: Camera): void {
    const { views, error, geometry, lift } = this.#settings;
    [this.#isCutRequested, this.#isCutStale] = [true, false];
    this.#tell({ kind: 'look', camera, settings: { views, error, isAround: false, geometry, lift } });
  }

  #hearCutter(message: FromCutter): void {
    switch (message.kind) {
      case 'opened':
        this.#open(message).catch((reason) => this.#fail(reason, true));
        break;
      case 'subtree':
        this.#tree?.cells.add(message.subtree);
        this.#catalog.add(message.subtree.shards, message.subtree.geometry);
        break;
      case 'cut':
        [this.#cut, this.#baseCut] = [message.cut, message.base];
        this.#isCutRequested = false;
        this.#isDirty = true;
        this.#requestViews();
        break;
      case 'received':
        this.#settings.onReceived(message.bytes);
        break;
      case 'failed':
        this.#settings.onFailure(message.failure, message.isFatal);
    }
  }

  #hearReader(message: FromReader): void {
    switch (message.kind) {
      case 'view':
      case 'leaf': {
        const view = this.#queue.done(message.id);
        if (view) this.#upload(view, message);
        this.#isDirty = true;
        this.#queue.fill();
        break;
      }
      case 'failed': {
        const view = this.#queue.failed(message.id, message.failure);
        if (view?.direction !== GEOMETRY) break;
        this.#undrawable.add(nameOf(0, view.place));
        this.#isDirty = true;
        this.#requestViews();
        break;
      }
      case 'cancelled':
        this.#queue.cancelled(message.id);
        break;
      case 'received':
        this.#settings.onReceived(message.bytes);
    }
  }

  async #open({ layout, shards, geometry }: Opened): Promise<void> {
    const { scripts, workers, base, bytes, graphics } = this.#settings;
    const onFailure = (message: string, isFatal: boolean): void => this.#fail(message, isFatal);
    const stock = await startStock(this.canvas, layout, { graphics, script: scripts.webgpu, bytes, onFailure });
    this.#tree = { cells: new Cells(layout), ...stock };
    this.#catalog.add(shards, geometry);
    this.#readers = startReaders(scripts.reader, workers, base, layout, (message) => this.#hearReader(message));
    this.#settings.onOpen(layout);
  }

  /** Uploads data to the GPU, which may have no memory for it. */
  #upload(view: ViewKey, message: FromReader & { readonly kind: 'view' | 'leaf' }): void {
    try {
      if (message.kind === 'view') this.#tree?.stock.addView(view, message.layers);
      else this.#tree?.stock.addLeaf(view.place, message.pieces);
    } catch (reason) {
      this.#fail(reason, false);
    }
  }

  #fail(reason: unknown, isFatal: boolean): void {
    this.#settings.onFailure({ kind: 'other', message: messageOf(reason) }, isFatal);
  }

  #choose(cut: Cut): Choice {
    const { cells, stock } = this.#tree as Tree;
    return choose(cut, cells, stock.directionsOf, this.#settings.views, (leaf) => this.#geometryState(leaf));
  }

  #geometryState(leaf: Triple): GeometryState {
    const { cells, stock } = this.#tree as Tree;
    if (this.#undrawable.has(nameOf(0, leaf))) return 'undrawable';
    if (stock.hasLeaf(leaf)) return 'loaded';
    const { tier, place } = subtreeOf(cells.layout, 0, leaf);
    // A leaf without files has nothing to load.
    return cells.knows(tier, place) && this.#catalog.filesOf(cells.layout, leaf).length === 0 ? 'loaded' : 'coming';
  }

  #draw(camera: Camera): void {
    if (!this.#tree || !this.#cut) return;
    const { cells, stock, graphics } = this.#tree;
    this.#hasMoved = this.#isDirty = false;
    this.#begin = performance.now();
    this.#isDrawing = true;
    const choice = this.#choose(this.#cut);
    const needed = this.#cut.leaves.flatMap(({ place }) => [place, ...cells.guestsOf(place)]);
    const counts = stock.draw(choice, camera, this.#settings.grid, {
      cells: new Set(this.#baseCut?.cells.map(({ level, place }) => nameOf(level, place))),
      leaves: new Set(needed.map((place) => nameOf(0, place))),
    });
    const { waiting } = this.#queue;
    const isCurrent = !this.#isCutRequested && !this.#isCutStale;
    const isComplete = isCurrent && waiting === 0 && this.#cut.unknown.length === 0;
    const { unbuilt } = this.#cut;
    this.#facts = { ...factsOf(choice, counts, stock), waiting, unbuilt, isComplete, graphics };
  }

  /** Requests missing views: coarse cells in the picture, then the cut, nearest first, then other coarse cells. */
  #requestViews(): void {
    if (!this.#tree) return;
    const requests = new Map<string, ViewRequest>();
    const coarse = (isInPicture: boolean): Cut | null =>
      this.#baseCut && { ...this.#baseCut, cells: this.#baseCut.cells.filter((cell) => cell.isInPicture === isInPicture) };
    for (const cut of [coarse(true), this.#cut, coarse(false)]) {
      if (!cut) continue;
      const { missingLeaves, missingViews } = this.#choose(cut);
      // Leaves are small files that cover most of the picture.
      const leaves = missingLeaves.map((place) => ({ level: 0, place, direction: GEOMETRY }));
      for (const view of [...leaves, ...missingViews]) {
        const name = viewName(view);
        if (!requests.has(name)) requests.set(name, this.#catalog.request(this.#tree.cells, view));
      }
    }
    this.#queue.replace(requests);
  }

  #tell(message: ToCutter): void {
    this.#cutter.postMessage(message);
  }
}
