/** Viewer of a tree: requests the cut for the camera and the cut's views, and draws what is loaded. */
import { messageOf } from '../../base/errors';
import type { Camera } from '../cut/camera';
import { Cells, type Cut, type FromCutter, type OpenedStore, type Settings, type ToCutter } from '../cut/cut';
import type { FromReader, ViewRequest } from '../decode/reader';
import type { Failure } from '../store/error';
import { GEOMETRY, type Layout, nameOf, subtreeOf, type Triple, type ViewKey, viewName } from '../store/layout';
import { Catalog } from './catalog';
import { Queue } from './queue';
import { type Readers, startReaders } from './readers';
import { type Facts, factsOf, type Graphics, INITIAL_FACTS, type ResidentTree } from './resident';
import { type Choice, choose, type GeometryState } from './stand_in';
import { startResidentTree } from './start';

export interface ViewerSettings extends Omit<Settings, 'includesOutside'> {
  readonly base: URL;
  readonly scripts: { readonly cutter: URL; readonly reader: URL; readonly webgpu: URL };
  readonly samplesPerAxis: number;
  /** Back end; null for the best one available. */
  readonly graphics: Graphics | null;
  /**
   * Limit for views on the GPU, bytes; geometry may take a quarter as much in addition. One picture may need more; then
   * the limits are exceeded.
   */
  readonly maxViewBytes: number;
  readonly workers: number;
  onOpen(layout: Layout): void;
  onReceived(bytes: number): void;
  onFailure(failure: Failure, isFatal: boolean): void;
  /** Called when the server answers again. */
  onRecovered(): void;
}

/** Concurrent requests per worker, so that a worker decodes some views while others are on their way. */
const REQUESTS_PER_WORKER = 6;
/** Least milliseconds between pictures of a camera at rest, which only new views change. */
const MIN_PAUSE_MS = 50;
/** Greatest share of the time for drawing such pictures. */
const MAX_DRAWING_SHARE = 0.5;

interface Tree {
  readonly cells: Cells;
  readonly resident: ResidentTree;
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
  #coarseCut: Cut | null = null;
  #camera: Camera | null = null;
  /** Whether a cut has been requested and not arrived; whether it is outdated because the camera has moved. */
  #isCutRequested = false;
  #isCutStale = false;
  /** Whether the camera has moved since the last picture; whether other views, leaves or another cut have arrived. */
  #hasMoved = true;
  #isDirty = true;
  /** Start and end time of the last picture, milliseconds. */
  #begin = 0;
  #end = 0;
  #isDrawing = false;
  #facts: Omit<Facts, 'drawnSplats'> = INITIAL_FACTS;

  constructor(readonly canvas: HTMLCanvasElement, settings: ViewerSettings) {
    this.#settings = settings;
    this.#cutter = new Worker(settings.scripts.cutter, { type: 'module' });
    this.#cutter.onmessage = ({ data }: MessageEvent<FromCutter>): void => this.#onCutterMessage(data);
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
    this.#sendToCutter({ kind: 'open', base: settings.base.href });
  }

  /** Sets the camera; draws a picture unless the last one is current or unfinished; returns whether it did. */
  frame(camera: Camera): boolean {
    if (!this.#tree) return false;
    if (JSON.stringify(this.#camera) !== JSON.stringify(camera)) {
      this.#camera = camera;
      this.#isCutStale = this.#hasMoved = true;
    }
    if (this.#isCutStale && !this.#isCutRequested) this.#requestCut(camera);
    // Failed views may be due for a retry.
    this.#queue.fill();
    if (!this.#cut || !this.#noteIfDone(this.#tree.resident)) return false;
    const pause = Math.max(MIN_PAUSE_MS, this.drawMs / MAX_DRAWING_SHARE - this.drawMs);
    const isDue = performance.now() - this.#end >= pause;
    if (!(this.#hasMoved || (this.#isDirty && (isDue || this.#queue.waiting === 0)))) return false;
    this.#draw(camera);
    return true;
  }

  get facts(): Facts {
    return { ...this.#facts, drawnSplats: this.#tree?.resident.drawer.drawnSplats ?? null };
  }

  /** Duration of the last picture, milliseconds. */
  get drawMs(): number {
    return Math.max(this.#end - this.#begin, 0);
  }

  /** Draws the last picture again; returns the milliseconds until the GPU has finished it. */
  async time(): Promise<number> {
    if (!this.#camera || !this.#tree) return 0;
    const { drawer } = this.#tree.resident;
    if (!drawer.isDone) await drawer.finish();
    this.#draw(this.#camera);
    const begin = this.#begin;
    await drawer.finish();
    return performance.now() - begin;
  }

  /**
   * Records the end of the last picture if the GPU has finished it; returns whether it has. Before that, pictures would
   * queue up.
   */
  #noteIfDone({ drawer }: ResidentTree): boolean {
    if (!this.#isDrawing) return true;
    if (!drawer.isDone) return false;
    this.#end = performance.now();
    this.#isDrawing = false;
    return true;
  }

  /** Repeats all failed requests. */
  retry(): void {
    this.#undrawable.clear();
    this.#queue.retry();
    this.#sendToCutter({ kind: 'retry' });
  }

  #requestCut(camera: Camera): void {
    const { views, error, geometry, raiseDegrees } = this.#settings;
    [this.#isCutRequested, this.#isCutStale] = [true, false];
    this.#sendToCutter({ kind: 'look', camera, settings: { views, error, includesOutside: false, geometry, raiseDegrees } });
  }

  #onCutterMessage(message: FromCutter): void {
    switch (message.kind) {
      case 'opened':
        this.#open(message).catch((reason) => this.#fail(reason, true));
        break;
      case 'subtree':
        this.#tree?.cells.add(message.subtree);
        this.#catalog.add(message.subtree.shards, message.subtree.geometry);
        break;
      case 'cut':
        [this.#cut, this.#coarseCut] = [message.cut, message.coarse];
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

  #onReaderMessage(message: FromReader): void {
    switch (message.kind) {
      case 'view':
      case 'leaf': {
        const view = this.#queue.recordArrival(message.id);
        if (view) this.#upload(view, message);
        this.#isDirty = true;
        this.#queue.fill();
        break;
      }
      case 'failed': {
        const view = this.#queue.recordFailure(message.id, message.failure);
        if (view?.direction !== GEOMETRY) break;
        this.#undrawable.add(nameOf(0, view.place));
        this.#isDirty = true;
        this.#requestViews();
        break;
      }
      case 'cancelled':
        this.#queue.recordCancellation(message.id);
        break;
      case 'received':
        this.#settings.onReceived(message.bytes);
    }
  }

  async #open({ layout, shards, geometry }: OpenedStore): Promise<void> {
    const { scripts, workers, base, maxViewBytes, graphics } = this.#settings;
    const onFailure = (message: string, isFatal: boolean): void => this.#fail(message, isFatal);
    const settings = { graphics, script: scripts.webgpu, maxViewBytes, onFailure };
    const started = await startResidentTree(this.canvas, layout, settings);
    this.#tree = { cells: new Cells(layout), ...started };
    this.#catalog.add(shards, geometry);
    this.#readers = startReaders(scripts.reader, workers, base, layout, (message) => this.#onReaderMessage(message));
    this.#settings.onOpen(layout);
  }

  /** Uploads a view or a leaf; the GPU may have no memory for it. */
  #upload(view: ViewKey, message: FromReader & { readonly kind: 'view' | 'leaf' }): void {
    try {
      if (message.kind === 'view') this.#tree?.resident.addView(view, message.layers);
      else this.#tree?.resident.addLeaf(view.place, message.pieces);
    } catch (reason) {
      this.#fail(reason, false);
    }
  }

  #fail(reason: unknown, isFatal: boolean): void {
    this.#settings.onFailure({ kind: 'other', message: messageOf(reason) }, isFatal);
  }

  #choose(cut: Cut): Choice {
    const { cells, resident } = this.#tree as Tree;
    return choose(cut, cells, resident.directionsOf, this.#settings.views, (leaf) => this.#geometryState(leaf));
  }

  #geometryState(leaf: Triple): GeometryState {
    const { cells, resident } = this.#tree as Tree;
    if (this.#undrawable.has(nameOf(0, leaf))) return 'undrawable';
    if (resident.hasLeaf(leaf)) return 'loaded';
    const { tier, place } = subtreeOf(cells.layout, 0, leaf);
    // A leaf without files has nothing to load.
    return cells.knows(tier, place) && this.#catalog.filesOf(cells.layout, leaf).length === 0 ? 'loaded' : 'missing';
  }

  #draw(camera: Camera): void {
    if (!this.#tree || !this.#cut) return;
    const { cells, resident, graphics } = this.#tree;
    this.#hasMoved = this.#isDirty = false;
    this.#begin = performance.now();
    this.#isDrawing = true;
    const choice = this.#choose(this.#cut);
    const needed = this.#cut.leaves.flatMap(({ place }) => [place, ...cells.leavesReachingInto(place)]);
    const counts = resident.draw(choice, camera, this.#settings.samplesPerAxis, {
      cells: new Set(this.#coarseCut?.cells.map(({ level, place }) => nameOf(level, place))),
      leaves: new Set(needed.map((place) => nameOf(0, place))),
    });
    const { waiting } = this.#queue;
    const isCurrent = !this.#isCutRequested && !this.#isCutStale;
    const isComplete = isCurrent && waiting === 0 && this.#cut.unknown.length === 0;
    const { unbuilt } = this.#cut;
    this.#facts = { ...factsOf(choice, counts, resident), waiting, unbuilt, isComplete, graphics };
  }

  /** Requests missing views: of coarse cells in the picture, of the cut, nearest first, then of other coarse cells. */
  #requestViews(): void {
    if (!this.#tree) return;
    const requests = new Map<string, ViewRequest>();
    const coarse = this.#coarseCut;
    const coarseCells = (isInPicture: boolean): Cut | null =>
      coarse && { ...coarse, cells: coarse.cells.filter((cell) => cell.isInPicture === isInPicture) };
    for (const cut of [coarseCells(true), this.#cut, coarseCells(false)]) {
      if (!cut) continue;
      const { missingLeaves, missingViews } = this.#choose(cut);
      // Leaves come first: their files are small and cover most of the picture.
      const leaves = missingLeaves.map((place) => ({ level: 0, place, direction: GEOMETRY }));
      for (const view of [...leaves, ...missingViews]) {
        const name = viewName(view);
        if (!requests.has(name)) requests.set(name, this.#catalog.request(this.#tree.cells, view));
      }
    }
    this.#queue.replace(requests);
  }

  #sendToCutter(message: ToCutter): void {
    this.#cutter.postMessage(message);
  }
}
